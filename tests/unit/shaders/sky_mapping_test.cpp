// Directions to table coordinates and back.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/shaders/glsl.h"
#include "unit/shaders/samples.h"

namespace cloudscape {
namespace {

using glsl::vec2;
constexpr double pi = 3.141592653589793238L;

TEST(TransmittanceMapping, GoesThereAndBack) {
  for (int i = -50; i <= 50; ++i)
    for (const float altitude : {0.0F, 10.0F, 1500.0F, 99000.0F}) {
      const vec2 uv = glsl::transmittance_uv(altitude, i / 50.0F);
      EXPECT_NEAR(glsl::transmittance_mu(uv.x), i / 50.0F, 1e-6);
      EXPECT_NEAR(glsl::transmittance_altitude_m(uv.y), altitude, 1e-5 * altitude + 1e-3);
    }
  EXPECT_EQ(glsl::transmittance_uv(0, -1), vec2(0, 0));
  EXPECT_EQ(glsl::transmittance_uv(2e5, 1), vec2(1, 1));  // above the top there is no more air
}

TEST(HorizonDip, IsTheAngleOfTheTangent) {
  for (const double altitude : {1.0, 100.0, 1000.0, 30000.0}) {
    const double exact = std::atan2(std::sqrt(altitude * (2 * 6360000.0 + altitude)), 6360000.0);
    EXPECT_NEAR(glsl::horizon_dip(altitude), exact, 1e-4);  // rad; a tenth of a pixel of the table at the horizon
  }
  EXPECT_EQ(glsl::horizon_dip(0), 0);
  EXPECT_EQ(glsl::horizon_dip(-3), 0);
}

TEST(SkyViewMapping, GoesThereAndBack) {
  for (const float dip : {0.0F, 0.0177F, 0.1F})
    for (int i = 0; i <= 40; ++i)
      for (int j = 0; j <= 20; ++j) {
        const float elevation = -pi / 2 + pi * i / 40, azimuth = pi * j / 20;
        const vec2 uv = glsl::sky_view_uv(elevation, std::cos(azimuth), dip);
        ASSERT_GE(std::min(uv.x, uv.y), 0);
        ASSERT_LE(std::max(uv.x, uv.y), 1 + 1e-6);
        const vec2 angles = glsl::sky_view_angles(uv, dip);
        EXPECT_NEAR(angles.x, elevation, 1e-5);
        EXPECT_NEAR(angles.y, azimuth, 1e-3);  // arc cosine is flat at 0 and pi
      }
}

TEST(SkyViewMapping, PutsTheHorizonInTheMiddleAndSpendsTexelsThere) {
  const float dip = 0.0177;
  EXPECT_EQ(glsl::sky_view_uv(-dip, 1, dip), vec2(0, 0.5));
  const auto rate = [dip](float elevation) {
    return (glsl::sky_view_uv(elevation + 0.01F, 1, dip).y - glsl::sky_view_uv(elevation, 1, dip).y) / 0.01F;
  };
  EXPECT_GT(rate(0.0), 3 * rate(0.5));
  EXPECT_GT(rate(-0.05), 3 * rate(-0.8));
}

// The middle of texel i stands for parameter i / (n - 1).
TEST(TableUv, HoldsTheExtremesAtTheMiddlesOfTheOuterTexels) {
  const vec2 size(192, 108);
  for (int i = 0; i < 108; ++i) {
    const vec2 uv = glsl::table_uv(glsl::table_parameter(vec2(i), size), size);
    EXPECT_NEAR(uv.x * size.x - 0.5, i, 1e-4);
    EXPECT_NEAR(uv.y * size.y - 0.5, i, 1e-4);
  }
  EXPECT_EQ(glsl::table_uv(vec2(-1, 2), size), vec2(0.5 / 192, 107.5 / 108));
}

}  // namespace
}  // namespace cloudscape
