// A baked terrain as numbers: from heights, by the processor, on any thread.
#pragma once
#include <cstdint>
#include <vector>

#include "bake/terrain_recipe.h"

namespace cloudscape::bake {

// The lattice has resolution^2 points, south row first. Level n has every 2^n-th point of it, so that all levels meet.
struct TerrainTexels {
  TerrainRecipe recipe;
  // Of each level, interleaved: the height of the surface, smoothed over the level's spacing, m above the base; and the
  // greatest height that the surface of this or of a finer level has in the cell north-east of the point.
  std::vector<std::vector<float>> heights;
  // RGBA16F of each point: slope east and north; share of the sky that the land around leaves free; how far the point
  // stands out (above 0) or lies in a hollow (below 0).
  std::vector<std::uint16_t> surface;
  float lowest_m = 0, highest_m = 0;
};

// `heights`: of noise in no unit, which are spread over 0..height_m; of a file times height_m. A map that does not tile
// goes down to 0 over its outer tenth.
TerrainTexels terrain_texels(const TerrainRecipe& recipe, std::vector<float> heights);

}  // namespace cloudscape::bake
