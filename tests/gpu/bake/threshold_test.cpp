// The threshold that leaves the wanted share of columns cloudy, counted in the texels themselves.
#include <algorithm>
#include <cmath>
#include <random>

#include "fixture.h"

namespace cloudscape::bake {
namespace {

constexpr int side = 16;
constexpr std::size_t columns = side * side;

// 256 columns whose greatest red values are 0..255 in a random order, at random heights. The other channels are random.
BakedTexels every_value_once() {
  BakedTexels texels{tiny_recipe(1), std::vector<std::uint8_t>(4 * columns * side), std::vector<std::uint8_t>(4),
                     std::vector<std::uint8_t>(8 * variation_resolution * variation_resolution)};
  texels.recipe.resolution = side;
  std::mt19937 random(1);
  for (std::uint8_t& byte : texels.shape) byte = static_cast<std::uint8_t>(random());
  for (std::size_t i = 0; i < texels.shape.size(); i += 4) texels.shape[i] = 0;
  std::vector<std::uint8_t> tops(columns);
  for (std::size_t i = 0; i < columns; ++i) tops[i] = static_cast<std::uint8_t>(i);
  std::shuffle(tops.begin(), tops.end(), random);
  for (std::size_t i = 0; i < columns; ++i) texels.shape[4 * (random() % side * columns + i)] = tops[i];
  return texels;
}

// Columns with a texel whose shape, the finer channels mixed in, exceeds the threshold.
int cloudy_columns(const std::vector<std::uint8_t>& shape, const std::array<double, 3>& weights, double threshold) {
  int count = 0;
  for (std::size_t column = 0; column < columns; ++column) {
    bool cloudy = false;
    for (std::size_t z = 0; z < side; ++z) {
      const std::uint8_t* texel = &shape[4 * (z * columns + column)];
      double fine = 1;
      for (std::size_t i = 0; i < 3; ++i) fine += weights[i] * (texel[i + 1] / 255.0 - 0.5);
      cloudy = cloudy || texel[0] / 255.0 * fine > threshold + 1e-6;
    }
    count += cloudy ? 1 : 0;
  }
  return count;
}

class Threshold : public BakeTest {};

TEST_F(Threshold, IsTheValueOfTheColumnInItsRank) {
  const BakedCloudscape baked(every_value_once());
  const std::array<double, 3> none{};
  EXPECT_NEAR(baked.threshold_for(0, none), 1, 1e-6);
  EXPECT_NEAR(baked.threshold_for(1, none), 0, 1e-6);
  EXPECT_NEAR(baked.threshold_for(0.5, none), 0.5, 1.01 / 255);
}

TEST_F(Threshold, LeavesTheWantedShareOfColumns) {
  const BakedTexels texels = every_value_once();
  const BakedCloudscape baked(texels);
  for (const std::array<double, 3>& weights : {std::array<double, 3>{}, {0.25, 0.12, 0.06}, {1, 0.6, 0.3}})
    for (const double coverage : {0.0, 0.1, 0.45, 0.5, 0.9, 1.0})
      EXPECT_NEAR(cloudy_columns(texels.shape, weights, baked.threshold_for(coverage, weights)), coverage * columns, 1)
          << coverage << ' ' << weights[0];
}

TEST_F(Threshold, FallsAsCoverageGrows) {
  const BakedCloudscape baked(bake(small_recipe()));
  const std::array<double, 3> weights{0.25, 0.12, 0.06};
  double before = 10;
  for (double coverage = 0; coverage <= 1; coverage += 0.05) {
    const double threshold = baked.threshold_for(coverage, weights);
    EXPECT_LE(threshold, before);
    before = threshold;
  }
}

// Many columns share a value of eight bits: those above the threshold are at most the wanted share, those at it fill
// up.
TEST_F(Threshold, OfABakeIsWithinATieOfTheShare) {
  const BakedTexels texels = bake(small_recipe());
  const BakedCloudscape baked(texels);
  for (const double coverage : {0.2, 0.5, 0.8}) {
    const double threshold = baked.threshold_for(coverage, {});
    EXPECT_LE(cloudy_columns(texels.shape, {}, threshold), coverage * columns + 1);
    EXPECT_GE(cloudy_columns(texels.shape, {}, threshold - 0.5 / 255), coverage * columns - 1);
  }
}

}  // namespace
}  // namespace cloudscape::bake
