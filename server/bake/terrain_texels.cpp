#include "bake/terrain_texels.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

namespace cloudscape::bake {
namespace {

// One number a point of a square lattice that wraps; its side is a power of two.
struct Lattice {
  int side;
  std::vector<float> values;
  std::size_t index(int x, int y) const {
    const int mask = side - 1;
    return static_cast<std::size_t>(y & mask) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x & mask);
  }
  float at(int x, int y) const { return values[index(x, y)]; }
};

Lattice empty_lattice(int side) {
  return {side, std::vector<float>(static_cast<std::size_t>(side) * static_cast<std::size_t>(side))};
}

template <class Value>
Lattice made(int side, const Value& value) {
  Lattice lattice = empty_lattice(side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) lattice.values[lattice.index(x, y)] = value(x, y);
  return lattice;
}

void scale(std::vector<float>& heights, const TerrainRecipe& recipe) {
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  const float bottom = *low, span = std::max(1e-6F, *high - *low);
  const auto top = static_cast<float>(recipe.height_m);
  const bool noise = recipe.height_map.empty();
  for (float& height : heights) height = top * (noise ? (height - bottom) / span : height);
}

// 0 at the edge of the map, 1 from a tenth of its size on.
float fade(int point, int side) {
  const float inwards = static_cast<float>(std::min(point, side - 1 - point)) / (0.1F * static_cast<float>(side));
  const float x = std::min(1.0F, inwards);
  return x * x * (3 - 2 * x);
}

Lattice scaled(const TerrainRecipe& recipe, std::vector<float> heights) {
  scale(heights, recipe);
  Lattice lattice{recipe.resolution, std::move(heights)};
  if (recipe.tiling) return lattice;
  for (int y = 0; y < lattice.side; ++y)
    for (int x = 0; x < lattice.side; ++x)
      lattice.values[lattice.index(x, y)] *= fade(x, lattice.side) * fade(y, lattice.side);
  return lattice;
}

// Every second point, smoothed by 1 2 1 both ways.
Lattice coarser_heights(const Lattice& fine) {
  const auto row = [&](int x, int y) { return 0.25F * (fine.at(x - 1, y) + 2 * fine.at(x, y) + fine.at(x + 1, y)); };
  return made(fine.side / 2, [&](int x, int y) {
    return 0.25F * (row(2 * x, 2 * y - 1) + 2 * row(2 * x, 2 * y) + row(2 * x, 2 * y + 1));
  });
}

float highest_corner(const Lattice& heights, int x, int y) {
  return std::max(std::max(heights.at(x, y), heights.at(x + 1, y)),
                  std::max(heights.at(x, y + 1), heights.at(x + 1, y + 1)));
}

Lattice coarser_maxima(const Lattice& fine, const Lattice& heights) {
  return made(heights.side, [&](int x, int y) {
    const float children = std::max(std::max(fine.at(2 * x, 2 * y), fine.at(2 * x + 1, 2 * y)),
                                    std::max(fine.at(2 * x, 2 * y + 1), fine.at(2 * x + 1, 2 * y + 1)));
    return std::max(children, highest_corner(heights, x, y));
  });
}

std::vector<float> interleaved(const Lattice& a, const Lattice& b) {
  std::vector<float> pairs;
  pairs.reserve(2 * a.values.size());
  for (std::size_t i = 0; i < a.values.size(); ++i) pairs.push_back(a.values[i]), pairs.push_back(b.values[i]);
  return pairs;
}

// Share of a sky of even radiance that a level surface sees: of eight directions the mean of cos^2 of the horizon's
// height. Farther points are taken from coarser levels.
float sky_share(const std::vector<Lattice>& levels, int x, int y, float spacing_m) {
  constexpr int directions[8][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  constexpr int level_of[] = {0, 0, 1, 2, 3}, distance_of[] = {1, 3, 8, 20, 48};  // tuned: up to 1.5 km in 32 m steps
  const float here = levels[0].at(x, y);
  float sum = 0;
  for (const auto& [east, north] : directions) {
    float tangent = 0;
    for (int i = 0; i < 5; ++i) {
      const int level = std::min(level_of[i], static_cast<int>(levels.size()) - 1), far = distance_of[i];
      const float there =
          levels[static_cast<std::size_t>(level)].at((x + east * far) >> level, (y + north * far) >> level);
      const float distance_m = static_cast<float>(far) * spacing_m * (east != 0 && north != 0 ? 1.41421356F : 1.0F);
      tangent = std::max(tangent, (there - here) / distance_m);
    }
    sum += 1 / (1 + tangent * tangent);
  }
  return sum / 8;
}

// A coarse level between its points; `shift`: how many times it was halved.
float interpolated(const Lattice& coarse, int x, int y, int shift) {
  const int points = 1 << shift, left = x >> shift, bottom = y >> shift;
  const float u = static_cast<float>(x & (points - 1)) / static_cast<float>(points);
  const float v = static_cast<float>(y & (points - 1)) / static_cast<float>(points);
  return std::lerp(std::lerp(coarse.at(left, bottom), coarse.at(left + 1, bottom), u),
                   std::lerp(coarse.at(left, bottom + 1), coarse.at(left + 1, bottom + 1), u), v);
}

std::vector<std::uint16_t> surface_of(const std::vector<Lattice>& levels, float spacing_m) {
  const Lattice& heights = levels[0];
  constexpr int shift = 3;  // a lattice has 64 points a side at least
  const Lattice& smooth = levels[shift];
  std::vector<std::uint16_t> texels;
  texels.reserve(4 * heights.values.size());
  for (int y = 0; y < heights.side; ++y)
    for (int x = 0; x < heights.side; ++x) {
      const float east = (heights.at(x + 1, y) - heights.at(x - 1, y)) / (2 * spacing_m);
      const float north = (heights.at(x, y + 1) - heights.at(x, y - 1)) / (2 * spacing_m);
      const float around = interpolated(smooth, x, y, shift);
      const float stands_out = std::clamp((heights.at(x, y) - around) / (2 * spacing_m), -1.0F, 1.0F);
      for (const float value : {east, north, sky_share(levels, x, y, spacing_m), stands_out})
        texels.push_back(glm::packHalf1x16(std::clamp(value, -1000.0F, 1000.0F)));
    }
  return texels;
}

}  // namespace

TerrainTexels terrain_texels(const TerrainRecipe& recipe, std::vector<float> heights) {
  std::vector<Lattice> levels{scaled(recipe, std::move(heights))};
  while (levels.back().side > 1) levels.push_back(coarser_heights(levels.back()));
  TerrainTexels texels;
  texels.recipe = recipe;
  Lattice maxima = made(levels[0].side, [&](int x, int y) { return highest_corner(levels[0], x, y); });
  texels.heights.push_back(interleaved(levels[0], maxima));
  for (std::size_t level = 1; level < levels.size(); ++level) {
    maxima = coarser_maxima(maxima, levels[level]);
    texels.heights.push_back(interleaved(levels[level], maxima));
  }
  const auto [low, high] = std::minmax_element(levels[0].values.begin(), levels[0].values.end());
  texels.lowest_m = *low, texels.highest_m = *high;
  texels.surface = surface_of(levels, static_cast<float>(recipe.size_m / recipe.resolution));
  return texels;
}

}  // namespace cloudscape::bake
