// Files that the build compiles into the program (shaders, the web page, presets); see cloudscape_embed in
// CMakeLists.txt.
#pragma once
#include <span>
#include <string_view>

namespace cloudscape {

struct EmbeddedFile {
  std::string_view path;  // below its root, with '/'
  std::string_view bytes;
};
using EmbeddedFiles = std::span<const EmbeddedFile>;

// The bytes of the file at `path`, or nullptr.
inline const EmbeddedFile* find(EmbeddedFiles files, std::string_view path) {
  for (const EmbeddedFile& file : files)
    if (file.path == path) return &file;
  return nullptr;
}

}  // namespace cloudscape
