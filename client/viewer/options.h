// The command line of the viewer.
#pragma once
#include <string>

#include "core/frame.h"
#include "viewer/endpoint.h"

namespace cloudscape::viewer {

struct Options {
  Endpoint endpoint;
  std::string cloudscape = "fair-weather-cumulus";  // a name that the server knows, or a file
  ImageSize size_px{1280, 720};
  Quality quality = Quality::standard;
  std::string log_level = "warn";
  bool headless = false;
  std::string path, out;  // headless: the camera path's file, the folder for frames and report
  int frames = 0;         // headless: poses of the path
  double fps = 30.0;      // headless: poses a second of path time
  bool live = false;      // headless: poses follow the wall clock, and the server may skip some
};

// Thrown after a message or the help was printed.
struct Exit {
  int code;
};

Options parse_options(int argc, char** argv);

}  // namespace cloudscape::viewer
