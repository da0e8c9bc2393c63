// The cloudscape document: text to value and back, its schema, and the named documents of a server.
#pragma once
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "core/cloudscape.h"

namespace cloudscape::settings {

// `source` (a file name, "body") opens messages about syntax. Throws InvalidInput.
Cloudscape parse_cloudscape(std::string_view text, const std::string& source);
// Throws OverLimit, at volume.resolution, where the cloudscape's baked textures are larger. `pointer` is where the
// document stands.
void check_bake(const Cloudscape& cloudscape, double max_bake_mib, const std::string& pointer);
std::string to_json(const Cloudscape& cloudscape);  // every field, indented
std::string cloudscape_schema();                    // JSON Schema 2020-12
std::string cloudscape_reference();                 // the document's reference as Markdown tables, for the README

// Named documents: the presets compiled into the program, those of a folder of *.json files, and those that were put.
// Names are 1 to 64 of a-z 0-9 - and begin with a letter. Thread-safe.
class CloudscapeLibrary {
 public:
  struct Entry {
    std::string name, title, description;
    bool preset = false;
  };
  // `folder` may be empty (nothing is read or stored). A broken file is logged, named, and left out.
  explicit CloudscapeLibrary(std::filesystem::path folder);
  ~CloudscapeLibrary();
  std::vector<Entry> list() const;
  std::shared_ptr<const Cloudscape> get(std::string_view name) const;  // throws NotFound, with the nearest name
  std::string text(std::string_view name) const;                       // as it was written, comments and all
  // Returns whether it is new. Throws InvalidInput (bad name, bad document), OverLimit (256 documents), Error (disk).
  bool put(const std::string& name,
           std::string_view text);       // stored atomically in the folder; presets cannot be replaced
  bool remove(const std::string& name);  // throws NotFound; InvalidInput for a preset

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// A file's path (it holds '/' or ends in .json) or a name of the library.
std::shared_ptr<const Cloudscape> find_cloudscape(const CloudscapeLibrary& library, const std::string& name_or_path);

}  // namespace cloudscape::settings
