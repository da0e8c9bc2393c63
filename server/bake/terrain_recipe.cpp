#include "bake/terrain_recipe.h"

#include <algorithm>
#include <cmath>

#include "core/content_hash.h"

namespace cloudscape::bake {
namespace {

namespace fs = std::filesystem;

// Largest seed of a document is 2^32 - 1; of a terrain 10^9. The shader has 32 bits, of which 6 are its own.
int seed_of(const Cloudscape& cloudscape) {
  constexpr std::uint64_t seeds = std::uint64_t{1} << 26;
  return static_cast<int>((cloudscape.seed + static_cast<std::uint64_t>(cloudscape.ground.terrain.seed)) % seeds);
}

void identify_file(TerrainRecipe& recipe, const fs::path& file) {
  std::error_code error;
  const auto written = fs::last_write_time(file, error).time_since_epoch();
  if (!error) recipe.height_map_written = std::chrono::duration<double>(written).count();
  const auto bytes = fs::file_size(file, error);
  if (!error) recipe.height_map_bytes = static_cast<double>(bytes);
}

}  // namespace

TerrainRecipe terrain_recipe(const Cloudscape& cloudscape, const fs::path& folder) {
  const Terrain& terrain = cloudscape.ground.terrain;
  TerrainRecipe recipe;
  recipe.resolution = terrain.resolution;
  recipe.size_m = terrain.size_m;
  recipe.height_m = terrain.height_m;
  recipe.tiling = terrain.tiling;
  recipe.height_map = terrain.height_map;
  if (!terrain.height_map.empty()) {
    identify_file(recipe, folder / terrain.height_map);
    return recipe;
  }
  recipe.seed = seed_of(cloudscape);
  // At least four lattice points to the narrowest ridge that is made.
  recipe.cells =
      std::clamp(static_cast<int>(std::lround(terrain.size_m / terrain.feature_m)), 1, terrain.resolution / 16);
  recipe.octaves = terrain.octaves;
  recipe.roughness = terrain.roughness;
  recipe.erosion = terrain.erosion;
  return recipe;
}

std::string terrain_key(const TerrainRecipe& recipe) { return content_hash(recipe); }

}  // namespace cloudscape::bake
