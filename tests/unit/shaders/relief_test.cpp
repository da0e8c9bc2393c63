// Mountains' noise: it repeats, its slope is its derivative; and the first root of a parabola.
#include <gtest/gtest.h>

#include "glsl.h"

namespace {

using glm::vec2, glm::vec3;

constexpr int cells = 5;

template <class Noise>
void expect_slope(const Noise& noise, float tolerance) {
  const float h = 1e-2F;
  for (int i = 0; i < 200; ++i) {
    const vec2 p(0.37F * i, 0.11F * i * i - 3);
    const vec3 at = noise(p);
    const float east = (noise(p + vec2(h, 0)).x - noise(p - vec2(h, 0)).x) / (2 * h);
    const float north = (noise(p + vec2(0, h)).x - noise(p - vec2(0, h)).x) / (2 * h);
    ASSERT_NEAR(at.y, east, tolerance) << i;
    ASSERT_NEAR(at.z, north, tolerance) << i;
  }
}

TEST(ReliefNoise, RepeatsAfterItsCellsAndNotBefore) {
  for (int i = 0; i < 100; ++i) {
    const vec2 p(0.0625F * i, 0.25F * i);
    EXPECT_NEAR(glsl::relief_noise(p, cells, 3U).x, glsl::relief_noise(p + vec2(cells, -2 * cells), cells, 3U).x,
                1e-4F);
    EXPECT_NEAR(glsl::relief_gullies(p, vec2(1, 0), cells, 3U).x,
                glsl::relief_gullies(p + vec2(-cells, cells), vec2(1, 0), cells, 3U).x, 1e-3F);
  }
  EXPECT_GT(std::abs(glsl::relief_noise(vec2(0.5F), cells, 3U).x - glsl::relief_noise(vec2(1.5F), cells, 3U).x), 1e-3F);
}

TEST(ReliefNoise, DependsOnItsSalt) {
  EXPECT_NE(glsl::relief_noise(vec2(0.5F), cells, 3U).x, glsl::relief_noise(vec2(0.5F), cells, 4U).x);
}

TEST(ReliefNoise, KnowsItsSlope) {
  expect_slope([](vec2 p) { return glsl::relief_noise(p, cells, 9U); }, 0.02F);
  expect_slope([](vec2 p) { return glsl::relief_ridges(glsl::relief_noise(p, cells, 9U), 0.3F); }, 0.04F);
}

TEST(ReliefRidges, AreHighestWhereTheNoiseIsZero) {
  EXPECT_FLOAT_EQ(glsl::relief_ridges(vec3(0, 2, 3), 0.05F).x, 0.9F);
  EXPECT_EQ(glsl::relief_ridges(vec3(0, 2, 3), 0.05F).y, 0) << "a crest is level across";
  EXPECT_LT(glsl::relief_ridges(vec3(0.3F, 2, 3), 0.05F).x, 0.5F);
  EXPECT_FLOAT_EQ(glsl::relief_ridges(vec3(0.3F, 2, 3), 0.05F).x, glsl::relief_ridges(vec3(-0.3F, 2, 3), 0.05F).x);
}

// Down the slope a gully stays as deep as it is; across it the ground rises and falls.
TEST(ReliefGullies, RunDownTheSlope) {
  float along = 0, across = 0;
  for (int i = 0; i < 400; ++i) {
    const vec2 p(0.173F * i, 0.091F * i);
    const vec3 gully = glsl::relief_gullies(p, vec2(0.6F, 0.8F), 64, 1U);
    EXPECT_LE(std::abs(gully.x), 1.0F);
    along += std::abs(gully.y * 0.6F + gully.z * 0.8F), across += std::abs(-gully.y * 0.8F + gully.z * 0.6F);
  }
  EXPECT_GT(across, 5 * along);
}

TEST(FirstRoot, IsTheSmallestWithinTheInterval) {
  const auto root = [](float a, float b, float c) { return glsl::first_root(c, 0.25F * a + 0.5F * b + c, a + b + c); };
  EXPECT_NEAR(root(1, -1, 0.21F), 0.3F, 1e-5F) << "of 0.3 and 0.7";
  EXPECT_NEAR(root(0, -2, 1), 0.5F, 1e-6F) << "a line";
  EXPECT_NEAR(root(-4, 1, 0.5F), 0.5F, 1e-5F) << "up, then down";
  EXPECT_GT(root(1, -1, 0.3F), 1.0F) << "touches nothing";
  EXPECT_GT(root(0, 2, 1), 1.0F) << "goes away";
  EXPECT_GT(root(0, -0.5F, 1), 1.0F) << "comes too late";
}

}  // namespace
