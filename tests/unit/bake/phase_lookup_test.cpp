// The shader's way into the table, in 32 bits, against the table's own. Compiled with -fsingle-precision-constant.
#include <gtest/gtest.h>

#include <cmath>

#include "bake/phase_table.h"
#include "unit/shaders/glsl.h"

namespace cloudscape::bake {
namespace {

constexpr long double degree = 3.14159265358979323846L / 180.0L;

float coordinate_of(double angle_rad) {
  const double azimuth = 0.7L, tilt = 0.4L;  // no axis of the world
  const glm::dvec3 sun(std::cos(azimuth) * std::cos(tilt), std::sin(azimuth) * std::cos(tilt), std::sin(tilt));
  const glm::dvec3 side = glm::normalize(glm::cross(sun, glm::dvec3(0, 0, 1)));
  const glm::vec3 direction(sun * std::cos(angle_rad) + side * std::sin(angle_rad)), towards(sun);
  return glsl::phase_table_coordinate(glm::length(direction - towards), glm::length(direction + towards));
}

TEST(PhaseLookup, FindsTheTexelOfEveryAngle) {
  for (const double angle_deg : {0.01L, 0.1L, 1.0L, 5.0L, 45.0L, 90.0L, 141.5L, 175.0L, 179.0L, 179.9L, 179.99L}) {
    const double texel = phase_table_cells * phase_coordinate(angle_deg * degree);
    EXPECT_NEAR(phase_table_cells * coordinate_of(angle_deg * degree), texel, 0.02L) << angle_deg;
  }
}

TEST(PhaseLookup, EndsAtBothEnds) {
  EXPECT_EQ(glsl::phase_table_coordinate(0, 2), 0);
  EXPECT_EQ(glsl::phase_table_coordinate(2, 0), 1);
  EXPECT_EQ(phase_coordinate(0), 0);
  EXPECT_NEAR(phase_coordinate(180 * degree), 1, 1e-7L);
}

TEST(PhaseLookup, AnglesAndCoordinatesAreInverse) {
  for (double coordinate = 0; coordinate <= 1; coordinate += 1.0L / 64)
    EXPECT_NEAR(phase_coordinate(phase_angle_rad(coordinate)), coordinate, 1e-7L);
}

}  // namespace
}  // namespace cloudscape::bake
