// The wind against closed forms: speed by altitude, how clouds lean by it, and how they change on their way.
#include "core/wind.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace cloudscape {
namespace {

Cloudscape sheared(double shear_per_s) {
  Cloudscape sky;
  sky.volume.origin_m.z = 1500;
  sky.volume.size_m = {8000, 8000, 2000};
  sky.wind.speed_m_per_s = 5, sky.wind.towards_azimuth_deg = 90, sky.wind.shear_per_s = shear_per_s;
  return sky;
}

TEST(Wind, GrowsWithAltitudeAndALayerDriftsWithThatAtItsBottom) {
  const Cloudscape sky = sheared(0.002);
  EXPECT_NEAR(wind_m_per_s(sky.wind, 0).x, 5, 1e-12);
  EXPECT_NEAR(wind_m_per_s(sky.wind, 3000).x, 11, 1e-12);
  EXPECT_NEAR(wind_m_per_s(sky.wind, 3000).y, 0, 1e-12);
  EXPECT_EQ(drift_m_per_s(sky), wind_m_per_s(sky.wind, 1500));
  Wind north_east;
  north_east.speed_m_per_s = 10, north_east.towards_azimuth_deg = 45;
  EXPECT_NEAR(wind_m_per_s(north_east, 700).x, 10 * std::numbers::sqrt2 / 2, 1e-12);
  EXPECT_NEAR(wind_m_per_s(north_east, 700).y, 10 * std::numbers::sqrt2 / 2, 1e-12);
}

TEST(Lean, GoesAsFarAsTheShearBlowsInTenMinutesAndNeverBelow45Degrees) {
  EXPECT_EQ(glm::length(lean_m(sheared(0))), 0);
  EXPECT_NEAR(lean_m(sheared(1e-5)).x, 1e-5 * 600 * 2000, 1e-3);
  EXPECT_NEAR(lean_m(sheared(-1e-5)).x, -1e-5 * 600 * 2000, 1e-3);
  double before_m = 0;
  for (const double shear : {0.0005, 0.001, 0.005, 0.02}) {
    const double lean = lean_m(sheared(shear)).x;
    EXPECT_GT(lean, before_m);
    EXPECT_LT(lean, 2000);
    before_m = lean;
  }
}

TEST(Lean, IsNotOfWhatHasItsPlace) {
  Cloudscape sky = sheared(0.01);
  sky.volume.tiling = false;
  EXPECT_EQ(glm::length(lean_m(sky)), 0);
  sky.volume.tiling = true;
  for (const VolumeKind kind : {VolumeKind::sphere, VolumeKind::slab, VolumeKind::vdb, VolumeKind::grid}) {
    sky.volume.kind = kind;
    EXPECT_EQ(glm::length(lean_m(sky)), 0);
    EXPECT_EQ(lean_stretch(sky), 1);
  }
}

// Where a way of 1 m leads before the lean, over all directions in the plane of the lean.
TEST(Lean, StretchesWaysAcrossByNoMoreThanItSays) {
  for (const double shear : {0.0, 0.001, -0.004, 0.02}) {
    const Cloudscape sky = sheared(shear);
    const double slope = lean_m(sky).x / sky.volume.size_m.z;
    double longest = 0;
    for (int i = 0; i < 3600; ++i) {
      const double angle = i * std::numbers::pi / 1800;
      longest = std::max(longest, std::abs(std::cos(angle) - slope * std::sin(angle)));
    }
    EXPECT_NEAR(lean_stretch(sky), longest, 1e-5);
    EXPECT_GE(lean_stretch(sky), longest);
  }
}

TEST(Evolution, IsNothingAtFirstAndGoesOnEvenly) {
  Wind wind = sheared(0.002).wind;
  wind.evolution_m_per_s = 0.5;
  EXPECT_EQ(glm::length(evolution(wind, 0).detail_m), 0);
  EXPECT_EQ(glm::length(evolution(wind, 0).coverage_m), 0);
  EXPECT_NEAR(evolution(wind, 100).detail_m.z, 50, 1e-12) << "the detail rises";
  EXPECT_GT(evolution(wind, 100).detail_m.x, 0) << "and goes downwind";
  EXPECT_GT(evolution(wind, 100).fine_detail_m.z, 50) << "the finer the faster";
  const Evolution once = evolution(wind, 1234), thrice = evolution(wind, 3 * 1234);
  EXPECT_NEAR(glm::length(thrice.fine_detail_m - 3.0 * once.fine_detail_m), 0, 1e-9);
  EXPECT_NEAR(glm::length(thrice.coverage_m - 3.0 * once.coverage_m), 0, 1e-9);
  wind.evolution_m_per_s = 0;
  EXPECT_EQ(glm::length(evolution(wind, 1e6).fine_detail_m), 0);
}

}  // namespace
}  // namespace cloudscape
