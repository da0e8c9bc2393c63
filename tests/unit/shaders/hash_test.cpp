// Random numbers from integers: evenly spread, unrelated between channels and neighbours. And the ground made of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "unit/shaders/glsl.h"
#include "unit/shaders/samples.h"

namespace cloudscape {
namespace {

using glsl::uvec3, glsl::vec2, glsl::vec3;

constexpr unsigned side = 48;
template <class Visit>
void for_each_cell(Visit visit) {
  for (unsigned z = 0; z < side; ++z)
    for (unsigned y = 0; y < side; ++y)
      for (unsigned x = 0; x < side; ++x) visit(uvec3(x, y, z));
}

// Chi-square with 63 degrees of freedom: mean 63, deviation 11.2; between 25 and 115 in all but one of a million cases.
TEST(Hash, FillsItsRangeEvenly) {
  for (int channel = 0; channel < 3; ++channel) {
    std::array<int, 64> bins{};
    for_each_cell([&](uvec3 cell) {
      const float value = glsl::hash_unit(cell)[channel];
      ASSERT_GE(value, 0);
      ASSERT_LT(value, 1);
      ++bins[static_cast<std::size_t>(value * 64)];
    });
    const double expected = side * side * side / 64.0;
    double chi_square = 0;
    for (const int count : bins) chi_square += (count - expected) * (count - expected) / expected;
    EXPECT_GT(chi_square, 25) << channel;
    EXPECT_LT(chi_square, 115) << channel;
  }
}

// The correlation of 110592 pairs has a standard error of 0.003.
TEST(Hash, HasUnrelatedChannelsAndNeighbours) {
  double channels = 0, east = 0, up = 0;
  for_each_cell([&](uvec3 cell) {
    const vec3 here = glsl::hash_unit(cell) - 0.5F;
    channels += here.x * here.y + here.y * here.z;
    east += here.x * (glsl::hash_unit(cell + uvec3(1, 0, 0)).x - 0.5F);
    up += here.z * (glsl::hash_unit(cell + uvec3(0, 0, 1)).z - 0.5F);
  });
  const double count = side * side * side, variance = 1.0 / 12;
  EXPECT_NEAR(channels / count / variance / 2, 0, 0.015);
  EXPECT_NEAR(east / count / variance, 0, 0.015);
  EXPECT_NEAR(up / count / variance, 0, 0.015);
}

// The avalanche: each bit of a cell's coordinates turns over each bit that counts in half of all cases. The share of
// 4096 cases deviates by 0.008.
TEST(Hash, MixesEveryBitOfACellIntoEveryBitOfItsWords) {
  for (int flipped = 0; flipped < 24; ++flipped)
    for (int channel = 0; channel < 3; ++channel) {
      std::array<int, 24> turned{};
      for (unsigned i = 0; i < 4096; ++i) {
        uvec3 cell(i % 16, i / 16 % 16, i / 256);
        const unsigned here = glsl::pcg3d(cell)[channel];
        cell[flipped / 8] ^= 1U << (flipped % 8);
        const unsigned changes = (here ^ glsl::pcg3d(cell)[channel]) >> 8;  // hash_unit drops the lowest eight
        for (std::size_t bit = 0; bit < 24; ++bit) turned[bit] += static_cast<int>(changes >> bit & 1);
      }
      for (const int count : turned) EXPECT_NEAR(count / 4096.0, 0.5, 0.05) << "bit " << flipped;
    }
}

TEST(InterleavedGradientNoise, FillsItsRangeEvenly) {
  std::array<int, 16> bins{};
  for (int y = 0; y < 360; ++y)
    for (int x = 0; x < 640; ++x) {
      const float value = glsl::interleaved_gradient_noise(vec2(x, y));
      ASSERT_GE(value, 0);
      ASSERT_LT(value, 1);
      ++bins[static_cast<std::size_t>(value * 16)];
    }
  for (const int count : bins) EXPECT_NEAR(count / (640 * 360 / 16.0), 1, 0.05);
}

// What it is for: every 3x3 block of pixels holds values from all over the range, so a small blur is near the mean.
TEST(InterleavedGradientNoise, IsSpreadOutInEverySmallBlock) {
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 120; ++x) {
      double sum = 0;
      for (int i = 0; i < 9; ++i) sum += glsl::interleaved_gradient_noise(vec2(x + i % 3, y + i / 3));
      ASSERT_NEAR(sum / 9, 0.5, 0.14) << x << ' ' << y;  // independent numbers deviate by 0.096, at most by 0.4 here
    }
}

TEST(GroundNoise, RepeatsAndHasNoSteps) {
  Samples samples;
  for (int i = 0; i < 2000; ++i) {
    const vec2 p(samples.between(-30000, 30000), samples.between(-30000, 30000));
    const float here = glsl::ground_noise(p, 1024, 2);
    ASSERT_GE(here, 0);
    ASSERT_LE(here, 1);
    ASSERT_NEAR(glsl::ground_noise(p + vec2(65536, -65536), 1024, 2), here, 1e-3);
    ASSERT_NEAR(glsl::ground_noise(p + vec2(1, 0), 1024, 2), here,
                1.6F / 1024 + 1e-5);  // the smooth step's slope is 1.5
  }
}

TEST(GroundTint, IsOneOnAverageAndWithoutVariation) {
  Samples samples;
  vec3 sum(0);
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const vec2 p(samples.between(-30000, 30000), samples.between(-30000, 30000));
    const vec3 tint = glsl::ground_tint(p, 1, 1);
    ASSERT_GT(std::min({tint.x, tint.y, tint.z}), 0);
    sum += tint;
    ASSERT_EQ(glsl::ground_tint(p, 1, 0), vec3(1));
  }
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(sum[i] / count, 1, 0.05);
}

// What is finer than a pixel is left out before it can flicker.
TEST(PatternContrast, IsGoneWhereAPixelIsHalfACell) {
  EXPECT_EQ(glsl::pattern_contrast(64, 32), 0);
  EXPECT_EQ(glsl::pattern_contrast(64, 1), 1);
  EXPECT_EQ(glsl::pattern_contrast(1024, 512), 0);
}

}  // namespace
}  // namespace cloudscape
