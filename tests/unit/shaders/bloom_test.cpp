// What glows: nothing up to the threshold, then the excess in its hue, and never more than the bound in all.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/shaders/glsl.h"

namespace cloudscape {
namespace {

using glsl::vec3;

TEST(BloomExcess, IsNothingUpToTheThreshold) {
  for (const float luminance : {0.0F, 0.5F, 1.0F, 2.0F})
    EXPECT_EQ(glsl::bloom_excess(vec3(luminance), 2), vec3(0)) << luminance;
  EXPECT_EQ(glsl::bloom_excess(vec3(0.1F, 0.2F, 20), 2), vec3(0)) << "bright in blue alone is not bright";
}

TEST(BloomExcess, IsTheLuminanceAboveTheThresholdInTheSameHue) {
  const vec3 color(40, 20, 5);
  const vec3 excess = glsl::bloom_excess(color, 3);
  EXPECT_NEAR(glsl::luminance(excess), glsl::luminance(color) - 3, 1e-5);
  EXPECT_NEAR(excess.x / excess.y, 2, 1e-5);
  EXPECT_NEAR(excess.y / excess.z, 4, 1e-5);
  EXPECT_EQ(glsl::bloom_excess(color, 0), color);
}

TEST(BloomExcess, StaysFiniteWhateverTheRadiance) {
  for (const float radiance : {1e20F, 3.4e38F, INFINITY}) {
    const vec3 excess = glsl::bloom_excess(vec3(radiance), 8);
    EXPECT_TRUE(std::isfinite(excess.x * 65536));
  }
}

TEST(BloomScale, LeavesLittleLightAloneAndBoundsMuch) {
  EXPECT_EQ(glsl::bloom_scale(0), 1);
  EXPECT_NEAR(glsl::bloom_scale(1e-4F), 1, 1e-3);
  float before = 0;
  for (float total = 1e-4F; total < 1e20F; total *= 3) {
    const float glowing = total * glsl::bloom_scale(total);
    EXPECT_GE(glowing, 0.99999F * before);
    EXPECT_LE(glowing, glsl::bloom_bound * 1.00001F);
    before = glowing;
  }
  EXPECT_NEAR(before, glsl::bloom_bound, 1e-5);
}

// Footprints side by side share each pixel out completely.
TEST(PixelOverlap, SharesEachPixelOut) {
  constexpr int pixels = 10, texels = 3;
  for (int i = 0; i < pixels; ++i) {
    float sum = 0;
    for (int texel = 0; texel < texels; ++texel)
      sum += glsl::pixel_overlap(i, texel * float(pixels) / texels, (texel + 1) * float(pixels) / texels);
    EXPECT_NEAR(sum, 1, 1e-5) << i;
  }
  EXPECT_EQ(glsl::pixel_overlap(4, 0, 4), 0);
}

}  // namespace
}  // namespace cloudscape
