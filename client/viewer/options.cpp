// The command line, by CLI11.
#include "viewer/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/version.h"

namespace cloudscape::viewer {
namespace {

constexpr int usage_error = 2;

constexpr const char* controls = R"(Controls:
  drag, or right click or L   look around; the latter two hold the pointer, Escape lets it go
  W A S D, Q E                fly ahead, left, back, right, down, up; Shift: five times as fast
  wheel                       speed
  arrow keys                  sun: left and right its azimuth, up and down its elevation
  [ and ]                     exposure
  T, Shift+T                  time forwards, backwards, a minute a second
  H                           figures in the window's title
  Escape                      quit
  game controller             sticks fly and look, triggers down and up, shoulders speed
Exit codes: 0 fine, 1 the server refuses or cannot be reached or a file cannot be written, 2 usage.)";

Quality quality_named(const std::string& name) {
  const auto& names = EnumNames<Quality>::names;
  return static_cast<Quality>(std::find(names.begin(), names.end(), name) - names.begin());
}

ImageSize parse_size(const std::string& text) {
  ImageSize size_px;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &size_px.width, &size_px.height, &rest) != 2 || size_px.width < 1 ||
      size_px.height < 1)
    throw InvalidInput("--size", "is '" + text + "': must be WIDTHxHEIGHT in pixels, such as 1280x720");
  return size_px;
}

struct Texts {
  std::string url, token, size = "1280x720", quality = "standard";
};

void add_view_options(CLI::App& app, Options& options, Texts& texts) {
  app.add_option("url", texts.url, "Server: ws://HOST:PORT, wss://, or the http:// link it printed at its start")
      ->required();
  app.add_option("--cloudscape", options.cloudscape, "Name of a cloudscape of the server, or a document's FILE.json")
      ->capture_default_str();
  app.add_option("--token", texts.token, "Token that the server wants")->envname("CLOUDSCAPE_TOKEN");
  app.add_option("--size", texts.size, "Size of the picture, WIDTHxHEIGHT in pixels")->capture_default_str();
  const std::vector<std::string> qualities(EnumNames<Quality>::names.begin(), EnumNames<Quality>::names.end());
  app.add_option("--quality", texts.quality, "Quality that a resting view reaches")
      ->check(CLI::IsMember(qualities))
      ->capture_default_str();
  app.add_option("--log-level", options.log_level, "debug, info, warn or error")
      ->check(CLI::IsMember({"debug", "info", "warn", "error"}))
      ->capture_default_str();
}

void add_recording_options(CLI::App& app, Options& options) {
  CLI::Option* headless = app.add_flag("--headless", options.headless, "Fly a camera path without a window");
  const auto add = [&](CLI::Option* option) { return option->needs(headless)->group("Headless"); };
  CLI::Option* path = add(app.add_option("--path", options.path, "Camera path, a JSON file"));
  CLI::Option* out = add(app.add_option("--out", options.out, "Folder for frame_0001.jpg ... and report.json"));
  CLI::Option* frames = add(app.add_option("--frames", options.frames, "Number of poses to fly through"));
  frames->check(CLI::Range(1, 1'000'000));
  add(app.add_option("--fps", options.fps, "Poses a second of path time"))
      ->check(CLI::Range(0.1, 240.0))
      ->capture_default_str();
  add(app.add_flag("--live", options.live,
                   "Fly by the wall clock: the server may skip poses, as it does for a person. Without it each pose "
                   "waits for its frame"));
  headless->needs(path)->needs(out)->needs(frames);
}

}  // namespace

Options parse_options(int argc, char** argv) {
  CLI::App app("Flies through a cloudscape that a server renders.", "cloudscape-viewer");
  app.footer(controls);
  app.set_version_flag("--version", std::string("cloudscape-viewer ") + version);
  Options options;
  Texts texts;
  add_view_options(app, options, texts);
  add_recording_options(app, options);
  try {
    app.parse(argc, argv);
    options.endpoint = parse_endpoint(texts.url);
    options.size_px = parse_size(texts.size);
    options.quality = quality_named(texts.quality);
  } catch (const CLI::ParseError& error) {
    throw Exit{app.exit(error) == 0 ? 0 : usage_error};
  } catch (const InvalidInput& error) {
    std::fprintf(stderr, "cloudscape-viewer: %s\n", error.what());
    throw Exit{usage_error};
  }
  if (!texts.token.empty()) options.endpoint.token = texts.token;
  return options;
}

}  // namespace cloudscape::viewer
