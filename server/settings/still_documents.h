// Stills as documents: those of config/stills and config/truth, compiled into the program and known by name, and files.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace cloudscape::settings {

// What POST /api/v1/stills takes, as text.
struct StillDocument {
  std::string text;
  std::string source;  // the file that opens errors; "" for a name or a body
};

struct StillEntry {
  std::string name, title, description;
  // Where it is seen from, and in what light, as parameters of GET /api/v1/stills and of a link to the page; "" if that
  // is more than a stream can show: a document of its own, or another lens than a perspective one.
  std::string view;
};

std::vector<StillEntry> named_stills();
StillDocument named_still(std::string_view name);  // throws NotFound, with the nearest name
// A file's path (it holds '/' or ends in .json) or a name. Throws NotFound, Error (cannot be read).
StillDocument find_still(const std::string& name_or_file);

// Those of config/truth, which `cloudscape bench truth` compares light models in. Throws NotFound likewise.
std::vector<StillEntry> truth_views();
StillDocument truth_view(std::string_view name);

}  // namespace cloudscape::settings
