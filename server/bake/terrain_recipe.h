// What a baked terrain depends on, and nothing else: cloudscapes with equal recipes share it, whatever their clouds.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

#include "core/cloudscape.h"

namespace cloudscape::bake {

struct TerrainRecipe {
  int version = 1;  // of the shader and of what follows it: raise it when they change what they make
  std::string height_map;
  double height_map_written = 0, height_map_bytes = 0;  // so that a file that was changed is read again
  int resolution = 1024;
  double size_m = 0, height_m = 0;
  bool tiling = true;
  // Of noise; 0 for a file.
  int seed = 0;
  int cells = 0, octaves = 0;
  double roughness = 0, erosion = 0;
  bool operator==(const TerrainRecipe&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("version", self.version, Limits{}, "");
    visit("height_map", self.height_map, Limits{}, "");
    visit("height_map_written", self.height_map_written, Limits{}, "");
    visit("height_map_bytes", self.height_map_bytes, Limits{}, "");
    visit("resolution", self.resolution, Limits{}, "");
    visit("size_m", self.size_m, Limits{}, "");
    visit("height_m", self.height_m, Limits{}, "");
    visit("tiling", self.tiling, Limits{}, "");
    visit("seed", self.seed, Limits{}, "");
    visit("cells", self.cells, Limits{}, "");
    visit("octaves", self.octaves, Limits{}, "");
    visit("roughness", self.roughness, Limits{}, "");
    visit("erosion", self.erosion, Limits{}, "");
  }
};

// Height maps are files of `folder` ("": there is none). A file that is missing is found out when it is read.
TerrainRecipe terrain_recipe(const Cloudscape& cloudscape, const std::filesystem::path& folder);
std::string terrain_key(const TerrainRecipe& recipe);  // 64 hexadecimal characters

}  // namespace cloudscape::bake
