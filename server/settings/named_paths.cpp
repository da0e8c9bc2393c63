#include "settings/named_paths.h"

#include <filesystem>
#include <vector>

#include "core/embedded.h"
#include "core/error.h"
#include "settings/json_text.h"
#include "settings/text_file.h"

namespace cloudscape {
extern const EmbeddedFiles embedded_paths;
}

namespace cloudscape::settings {
namespace {

constexpr std::size_t max_file_bytes = 4 << 20;  // the most keys, written at length

}  // namespace

CameraPath named_path(std::string_view name) {
  if (const EmbeddedFile* file = find(embedded_paths, std::string(name) + ".json"))
    return parse_camera_path(file->bytes, std::string(file->path));
  std::vector<std::string> names;
  for (const EmbeddedFile& file : embedded_paths) names.push_back(std::filesystem::path(file.path).stem().string());
  const std::vector<std::string_view> known(names.begin(), names.end());
  throw NotFound("there is no path " + shown(std::string(name)) + ": " + suggestion(name, known));
}

CameraPath find_path(const std::string& name_or_file) {
  if (name_or_file.find('/') == std::string::npos && !name_or_file.ends_with(".json")) return named_path(name_or_file);
  return parse_camera_path(read_text_file(name_or_file, max_file_bytes), name_or_file);
}

}  // namespace cloudscape::settings
