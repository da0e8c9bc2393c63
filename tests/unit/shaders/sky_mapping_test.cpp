// Altitudes, directions and distances to table coordinates and back.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/shaders/glsl.h"
#include "unit/shaders/samples.h"

namespace cloudscape {
namespace {

using glsl::vec2;
constexpr double pi = 3.141592653589793238L;

TEST(TransmittanceMapping, GoesThereAndBack) {
  for (const float altitude : {0.0F, 10.0F, 1500.0F, 30000.0F, 99000.0F}) {
    const float horizon = -glsl::horizon_sine(altitude);
    for (int i = 0; i <= 50; ++i) {
      const float mu = horizon + (1 - horizon) * i / 50.0F;
      const vec2 uv = glsl::transmittance_uv(altitude, mu);
      ASSERT_GE(uv.x, -1e-6);
      ASSERT_LE(uv.x, 1 + 1e-6);
      EXPECT_NEAR(glsl::transmittance_mu(uv.x, altitude), mu, altitude > 90000 ? 1e-3 : 2e-5) << altitude;
      EXPECT_NEAR(glsl::transmittance_altitude_m(uv.y), altitude, 1e-4 * altitude + 0.01);
    }
  }
}

TEST(TransmittanceMapping, SpendsTexelsAtTheHorizon) {
  const double degree = pi / 180;
  const double low =
      glsl::transmittance_uv(0, std::sin(1 * degree)).x - glsl::transmittance_uv(0, std::sin(2 * degree)).x;
  const double high =
      glsl::transmittance_uv(0, std::sin(61 * degree)).x - glsl::transmittance_uv(0, std::sin(62 * degree)).x;
  EXPECT_GT(low, 20 * high);
}

TEST(MultipleMapping, GoesThereAndBack) {
  for (int i = -20; i <= 50; ++i) {
    const float mu = i / 50.0F;
    EXPECT_NEAR(glsl::multiple_mu(glsl::multiple_uv(0, mu).x), mu, 1e-5);
  }
  for (const float altitude : {0.0F, 100.0F, 5000.0F, 90000.0F})
    EXPECT_NEAR(glsl::multiple_altitude_m(glsl::multiple_uv(altitude, 0).y), altitude, 1e-4 * altitude);
}

TEST(HorizonDistance, IsTheTangent) {
  for (const double altitude : {1.0, 100.0, 1000.0, 30000.0}) {
    EXPECT_NEAR(glsl::horizon_distance_m(altitude) / std::sqrt(altitude * (2 * 6360000.0 + altitude)), 1, 1e-6);
    EXPECT_NEAR(glsl::horizon_sine(altitude), std::sin(std::acos(6360000.0 / (6360000.0 + altitude))), 1e-6);
  }
  EXPECT_EQ(glsl::horizon_distance_m(-3), 0);
}

TEST(AzimuthCoordinate, GoesThereAndBack) {
  for (const bool mirrored : {true, false})
    for (int i = -35; i <= 35; ++i) {
      const double azimuth = pi * i / 36;
      const float u = glsl::azimuth_coordinate(std::cos(azimuth), std::sin(azimuth), mirrored);
      ASSERT_GE(u, 0);
      ASSERT_LE(u, 1);
      const vec2 back = glsl::azimuth_direction(u, mirrored);
      EXPECT_NEAR(back.x, std::cos(azimuth), 1e-5);
      EXPECT_NEAR(back.y, mirrored ? std::abs(std::sin(azimuth)) : std::sin(azimuth), 1e-5);
    }
  EXPECT_EQ(glsl::azimuth_coordinate(1, 0, true), 0);
  EXPECT_EQ(glsl::azimuth_coordinate(-1, 0, true), 1);
}

TEST(SkyViewMapping, GoesThereAndBackAndBeginsAtTheHorizon) {
  for (const float dip : {0.0F, 0.0177F, 0.1F}) {
    for (int i = 0; i <= 40; ++i) {
      const float sine = -dip + (1 + dip) * i / 40;
      EXPECT_NEAR(glsl::sky_view_sine(glsl::sky_view_v(sine, dip), dip), sine, 1e-5);
    }
    EXPECT_EQ(glsl::sky_view_v(-dip, dip), 0);
    EXPECT_GT(glsl::sky_view_v(-dip + 0.01F, dip), 0.09);
  }
}

TEST(AerialMapping, GoesThereAndBack) {
  for (const float dip : {0.0F, 0.06F, 0.34F}) {
    for (int i = -50; i <= 50; ++i)
      EXPECT_NEAR(glsl::aerial_sine(glsl::aerial_v(i / 50.0F, dip), dip), i / 50.0F, 1e-5);
    EXPECT_EQ(glsl::aerial_v(-dip, dip), 0.5);
  }
  for (const float distance : {0.0F, 10.0F, 5000.0F, 40000.0F, 500000.0F})
    EXPECT_NEAR(glsl::aerial_distance_m(glsl::aerial_w(distance)), distance, 1e-4 * distance);
  EXPECT_EQ(glsl::aerial_w(1e9F), 1);
}

TEST(AerialMapping, BeginsBelowItsCeiling) {
  EXPECT_EQ(glsl::aerial_begin_m(12000, glsl::vec3(0, 0, -1)), 0);
  EXPECT_NEAR(glsl::aerial_begin_m(30000, glsl::vec3(0, 0, -1)), 14000, 2);
  EXPECT_EQ(glsl::aerial_begin_m(30000, glsl::vec3(0, 0, 1)), 0);
  // Nothing jumps where rays just miss it.
  const double tangent = -std::sqrt(1 - std::pow(6376000.0 / 6390000.0, 2));
  const auto begin = [](double sine) {
    return glsl::aerial_begin_m(30000, glsl::vec3(std::sqrt(1 - sine * sine), 0, sine));
  };
  EXPECT_NEAR(begin(tangent + 1e-6) / begin(tangent - 1e-6), 1, 0.03);
}

// The middle of texel i stands for parameter i / (n - 1).
TEST(TableUv, HoldsTheExtremesAtTheMiddlesOfTheOuterTexels) {
  const vec2 size(192, 108);
  for (int i = 0; i < 108; ++i) {
    const vec2 uv = glsl::table_uv(glsl::table_parameter(vec2(i), size), size);
    EXPECT_NEAR(uv.x * size.x - 0.5, i, 1e-4);
    EXPECT_NEAR(uv.y * size.y - 0.5, i, 1e-4);
    EXPECT_NEAR(glsl::table_u(i / 107.0F, 108), uv.y, 1e-6);
  }
  EXPECT_EQ(glsl::table_uv(vec2(-1, 2), size), vec2(0.5 / 192, 107.5 / 108));
}

}  // namespace
}  // namespace cloudscape
