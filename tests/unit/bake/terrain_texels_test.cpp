// The levels of a terrain: what the march relies on.
#include "bake/terrain_texels.h"

#include <gtest/gtest.h>

#include <glm/gtc/packing.hpp>
#include <random>

namespace cloudscape::bake {
namespace {

constexpr int side = 64;

TerrainRecipe recipe_of_file() {
  TerrainRecipe recipe;
  recipe.height_map = "a.png";
  recipe.resolution = side;
  recipe.size_m = 6400, recipe.height_m = 1000;
  return recipe;
}

std::vector<float> random_heights() {
  std::mt19937 random(7);
  std::vector<float> heights(side * side);
  for (float& height : heights) height = static_cast<float>(random() % 1000) / 1000.0F;
  return heights;
}

// (height, greatest height) of a point of a level.
std::pair<float, float> point(const TerrainTexels& texels, int level, int x, int y) {
  const int mask = (side >> level) - 1;
  const std::size_t i = 2 * static_cast<std::size_t>((y & mask) * (side >> level) + (x & mask));
  const auto& values = texels.heights[static_cast<std::size_t>(level)];
  return {values[i], values[i + 1]};
}

TEST(TerrainLevels, HaveHeightsInMetres) {
  std::vector<float> heights = random_heights();
  const TerrainTexels texels = terrain_texels(recipe_of_file(), heights);
  ASSERT_EQ(texels.heights.size(), 7U);
  EXPECT_FLOAT_EQ(point(texels, 0, 5, 9).first, 1000 * heights[9 * side + 5]);
}

// Leaving out a cell is right only if no surface in it, of this level or a finer one, is higher than it says.
TEST(TerrainLevels, BoundEverySurfaceInACell) {
  const TerrainTexels texels = terrain_texels(recipe_of_file(), random_heights());
  int bounded = 0;
  for (int level = 0; level < 7; ++level)
    for (int finer = 0; finer <= level; ++finer)
      for (int y = 0; y <= side >> finer; ++y)
        for (int x = 0; x <= side >> finer; ++x, ++bounded) {
          const float height = point(texels, finer, x, y).first;
          const int shift = level - finer;
          ASSERT_LE(height, point(texels, level, x >> shift, y >> shift).second);
          ASSERT_LE(height, point(texels, level, (x - 1) >> shift, (y - 1) >> shift).second)
              << "its corners belong to it";
        }
  EXPECT_GT(bounded, 10000);
}

TEST(TerrainLevels, OfLevelLandAreLevelAndSeeTheWholeSky) {
  const TerrainTexels texels = terrain_texels(recipe_of_file(), std::vector<float>(side * side, 0.5F));
  for (int level = 0; level < 7; ++level) EXPECT_EQ(point(texels, level, 3, 3), std::pair(500.0F, 500.0F));
  const float expected[] = {0, 0, 1, 0};
  for (std::size_t i = 0; i < texels.surface.size(); ++i)
    ASSERT_EQ(glm::unpackHalf1x16(texels.surface[i]), expected[i % 4]);
}

TEST(TerrainLevels, KnowSlopesAndPits) {
  std::vector<float> heights(side * side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      heights[static_cast<std::size_t>(y * side + x)] = 0.01F * static_cast<float>(x) + 0.02F * static_cast<float>(y);
  heights[40 * side + 40] -= 0.5F;
  const TerrainTexels texels = terrain_texels(recipe_of_file(), heights);
  const auto surface = [&](int x, int y, int channel) {
    return glm::unpackHalf1x16(texels.surface[static_cast<std::size_t>(4 * (y * side + x) + channel)]);
  };
  EXPECT_NEAR(surface(20, 20, 0), 10 / 100.0, 1e-3);
  EXPECT_NEAR(surface(20, 20, 1), 20 / 100.0, 1e-3);
  EXPECT_LT(surface(40, 40, 2), 0.2) << "500 m deep and 100 m wide";
  EXPECT_LT(surface(40, 40, 3), -0.5);
}

TEST(TerrainLevels, OfNoiseFillTheWholeHeight) {
  TerrainRecipe recipe = recipe_of_file();
  recipe.height_map.clear();
  std::vector<float> heights = random_heights();
  for (float& height : heights) height = 3 * height - 7;
  const TerrainTexels texels = terrain_texels(recipe, heights);
  EXPECT_EQ(texels.lowest_m, 0);
  EXPECT_EQ(texels.highest_m, 1000);
}

TEST(TerrainLevels, OfASingleMapMeetThePlainAtItsEdge) {
  TerrainRecipe recipe = recipe_of_file();
  recipe.tiling = false;
  const TerrainTexels texels = terrain_texels(recipe, std::vector<float>(side * side, 1.0F));
  for (int i = 0; i < side; ++i)
    for (const auto& [x, y] : {std::pair(i, 0), std::pair(0, i), std::pair(i, side - 1), std::pair(side - 1, i)})
      EXPECT_EQ(point(texels, 0, x, y).first, 0);
  EXPECT_LT(point(texels, 0, 1, 32).first, 100) << "no cliff";
  EXPECT_EQ(point(texels, 0, 32, 32).first, 1000);
}

TEST(TerrainRecipes, DependOnNothingButTheTerrain) {
  Cloudscape a;
  Cloudscape b = a;
  b.shape.coverage = 0.9, b.sun.azimuth_deg = 3, b.ground.terrain.snow_line_m = 1, b.ground.terrain.base_m = 5;
  EXPECT_EQ(terrain_key(terrain_recipe(a, {})), terrain_key(terrain_recipe(b, {})));
  for (void (*change)(Cloudscape&) :
       {+[](Cloudscape& c) { c.seed = 99; }, +[](Cloudscape& c) { c.ground.terrain.seed = 1; },
        +[](Cloudscape& c) { c.ground.terrain.height_m = 100; },
        +[](Cloudscape& c) { c.ground.terrain.tiling = false; },
        +[](Cloudscape& c) { c.ground.terrain.height_map = "x.png"; },
        +[](Cloudscape& c) { c.ground.terrain.erosion = 0; }}) {
    Cloudscape changed = a;
    change(changed);
    EXPECT_NE(terrain_key(terrain_recipe(a, {})), terrain_key(terrain_recipe(changed, {})));
  }
}

}  // namespace
}  // namespace cloudscape::bake
