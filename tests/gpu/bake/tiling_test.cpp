// Bakes are the same each time and have no seams.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/glm.hpp>

#include "fixture.h"

namespace cloudscape::bake {
namespace {

// Mean difference of neighbours between each plane across `axis` and the next; the last is the one across the seam.
std::vector<double> plane_differences(const std::vector<std::uint8_t>& rgba, int side, int axis, int channel) {
  std::vector<double> differences(static_cast<std::size_t>(side), 0.0);
  const auto at = [&](glm::ivec3 p) {
    return rgba[static_cast<std::size_t>(4 * ((p.z * side + p.y) * side + p.x) + channel)];
  };
  for (int i = 0; i < side * side * side; ++i) {
    const glm::ivec3 here(i % side, i / side % side, i / side / side);
    glm::ivec3 next = here;
    next[axis] = (next[axis] + 1) % side;
    differences[static_cast<std::size_t>(here[axis])] +=
        std::abs(at(here) - at(next)) / static_cast<double>(side * side);
  }
  return differences;
}

void expect_no_seam(const std::vector<std::uint8_t>& rgba, int side, int axis, int channel) {
  std::vector<double> differences = plane_differences(rgba, side, axis, channel);
  const double seam = differences.back();
  differences.pop_back();
  EXPECT_LE(seam, 1.1 * *std::max_element(differences.begin(), differences.end()))
      << "axis " << axis << " channel " << channel;
  EXPECT_GT(differences.front(), 0);
}

class Tiling : public BakeTest {};

// Red is not periodic upwards: the height distribution makes it a layer.
TEST_F(Tiling, ShapeHasNoSeams) {
  BakeRecipe recipe = small_recipe();
  recipe.resolution = 32;
  const std::vector<std::uint8_t> shape = bake(recipe).shape;
  for (int axis = 0; axis < 3; ++axis)
    for (int channel = axis == 2 ? 1 : 0; channel < 4; ++channel) expect_no_seam(shape, 32, axis, channel);
}

TEST_F(Tiling, DetailHasNoSeams) {
  BakeRecipe recipe = small_recipe();
  recipe.detail_resolution = 32;
  const std::vector<std::uint8_t> detail = bake(recipe).detail;
  for (int axis = 0; axis < 3; ++axis)
    for (const int channel : {0, 1}) expect_no_seam(detail, 32, axis, channel);
}

class Repetition : public BakeTest {};

TEST_F(Repetition, GivesTheSameBytes) { EXPECT_EQ(bake(small_recipe()), bake(small_recipe())); }

TEST_F(Repetition, WithAnotherSeedGivesOtherNoise) {
  BakeRecipe other = small_recipe();
  other.seed = 6;
  const BakedTexels a = bake(small_recipe()), b = bake(other);
  EXPECT_NE(a.shape, b.shape);
  EXPECT_NE(a.detail, b.detail);
  EXPECT_NE(a.variation, b.variation);
}

// Noise that came out nearly grey would leave the march nothing to carve: four standard deviations, which hold nearly
// all texels, span at least a quarter of the eight bits.
TEST_F(Repetition, HasContrastInEveryChannel) {
  BakeRecipe recipe;
  recipe.resolution = 32;
  const std::vector<std::uint8_t> shape = bake(recipe).shape;
  for (std::size_t channel = 1; channel < 4; ++channel) {
    double sum = 0, squares = 0;
    for (std::size_t i = channel; i < shape.size(); i += 4) sum += shape[i], squares += shape[i] * shape[i];
    const double mean = sum / (32 * 32 * 32), deviation = std::sqrt(squares / (32 * 32 * 32) - mean * mean);
    EXPECT_NEAR(mean, 128, 48) << "channel " << channel;
    EXPECT_GT(deviation, 16) << "channel " << channel;
  }
}

}  // namespace
}  // namespace cloudscape::bake
