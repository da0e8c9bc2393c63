#include "settings/named_files.h"

#include "core/content_hash.h"
#include "core/file_stamp.h"

namespace cloudscape::settings {

std::string stamps_of_named_files(const Cloudscape& cloudscape, const ServerSettings& settings) {
  const auto stamp = [](const std::string& folder, const std::string& name) {
    return content_hash(file_stamp(std::filesystem::path(folder) / name));
  };
  std::string stamps;
  const Ground& ground = cloudscape.ground;
  if (ground.kind == GroundKind::terrain && !ground.terrain.height_map.empty())
    stamps += stamp(settings.height_map_dir, ground.terrain.height_map);
  if (is_from_file(cloudscape.volume.kind)) stamps += stamp(settings.volume_dir, cloudscape.volume.grid.file);
  return stamps;
}

}  // namespace cloudscape::settings
