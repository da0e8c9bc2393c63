// The flight model against directions that a compass gives.
#include "viewer/flight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace cloudscape::viewer {
namespace {

CameraPose pose_towards(double azimuth_deg, double elevation_deg) {
  return {{100.0, 200.0, 1000.0}, azimuth_deg, elevation_deg, 0.0};
}

glm::dvec3 way_m(const CameraPose& pose, const FlightInput& input, double speed_m_per_s = 50, double duration_s = 2) {
  return fly(pose, input, speed_m_per_s, duration_s).position_m - pose.position_m;
}

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], 1e-9) << "component " << i;
}

TEST(Flight, ForwardFollowsTheCompass) {
  expect_near(way_m(pose_towards(0, 0), {.forward = 1}), {0, 100, 0});
  expect_near(way_m(pose_towards(90, 0), {.forward = 1}), {100, 0, 0});
  expect_near(way_m(pose_towards(180, 0), {.forward = 1}), {0, -100, 0});
  expect_near(way_m(pose_towards(90, 30), {.forward = 1}), {100 * std::sqrt(0.75), 0, 50});
}

TEST(Flight, RightIsLevelAndUpIsUpWhereverItLooks) {
  expect_near(way_m(pose_towards(0, 80), {.right = 1}), {100, 0, 0});
  expect_near(way_m(pose_towards(90, -80), {.right = -1}), {0, 100, 0});
  expect_near(way_m(pose_towards(45, -60), {.up = 1}), {0, 0, 100});
}

TEST(Flight, DiagonalsAreNoFasterAndHalfDeflectionIsHalfAsFast) {
  EXPECT_NEAR(glm::length(way_m(pose_towards(20, 10), {.forward = 1, .right = 1, .up = 1})), 100, 1e-9);
  EXPECT_NEAR(glm::length(way_m(pose_towards(20, 10), {.forward = 0.5})), 50, 1e-9);
  EXPECT_NEAR(glm::length(way_m(pose_towards(20, 10), {.forward = 1, .fast = true})), 100 * fast_factor, 1e-9);
}

TEST(Flight, ManySmallStepsGoAsFarAsOneLarge) {
  CameraPose pose = pose_towards(30, 5);
  const CameraPose there = fly(pose, {.forward = 1, .right = 0.2}, 50, 2);
  for (int i = 0; i < 100; ++i) pose = fly(pose, {.forward = 1, .right = 0.2}, 50, 0.02);
  expect_near(pose.position_m, there.position_m);
}

TEST(Flight, TurnsWrapRoundNorthAndStopAtTheZenith) {
  EXPECT_NEAR(fly(pose_towards(350, 0), {.turn_right_deg = 20}, 0, 0).azimuth_deg, 10, 1e-9);
  EXPECT_NEAR(fly(pose_towards(10, 0), {.turn_right_deg = -20}, 0, 0).azimuth_deg, 350, 1e-9);
  EXPECT_EQ(fly(pose_towards(0, 80), {.turn_up_deg = 30}, 0, 0).elevation_deg, 90);
  EXPECT_EQ(fly(pose_towards(0, -80), {.turn_up_deg = -30}, 0, 0).elevation_deg, -90);
}

TEST(Flight, NoInputLeavesThePoseAlone) { EXPECT_EQ(fly(pose_towards(33, -7), {}, 1000, 10), pose_towards(33, -7)); }

TEST(Flight, StopsAtTheGroundWhichCurvesAway) {
  CameraPose pose = pose_towards(90, -90);
  pose.position_m = {0, 0, 10};
  EXPECT_NEAR(fly(pose, {.forward = 1}, 1000, 1).position_m.z, 1.7, 1e-6);
  // 100 km from the origin the ground is x^2 / 2R = 786.2 m lower.
  pose.position_m = {100'000, 0, 0};
  const glm::dvec3 landed = fly(pose, {.forward = 1}, 1000, 1).position_m;
  EXPECT_NEAR(landed.z, 1.7 - 786, 0.3);
  EXPECT_NEAR(altitude_m(landed), 1.7, 1e-6);
}

TEST(Flight, BelowTheGroundItFliesFreely) {
  CameraPose pose = pose_towards(0, -90);
  pose.position_m = {0, 0, -500};
  EXPECT_NEAR(fly(pose, {.forward = 1}, 100, 1).position_m.z, -600, 1e-9);
}

TEST(Flight, NeverLeavesWhatAPoseMayBe) {
  CameraPose pose = pose_towards(90, 0);
  pose.position_m.x = 9.99e6;
  EXPECT_EQ(fly(pose, {.forward = 1}, 20'000, 60).position_m.x, 1e7);
}

TEST(Flight, TheWheelIsExactlyReversibleWithinItsRange) {
  EXPECT_NEAR(change_speed(change_speed(200, 3), -3), 200, 1e-9);
  EXPECT_GT(change_speed(200, 1), 200);
  EXPECT_EQ(change_speed(200, -1000), 1);
  EXPECT_EQ(change_speed(200, 1000), 20'000);
}

TEST(Flight, TheWindowsHeightIsTheFieldOfView) {
  Lens lens;
  lens.vertical_fov_deg = 50;
  EXPECT_NEAR(degrees_per_pixel(lens, 500) * 500, 50, 1e-9);
  EXPECT_TRUE(std::isfinite(degrees_per_pixel(lens, 0)));
}

TEST(Flight, SticksRestInTheMiddleAndReachTheEnds) {
  EXPECT_EQ(deflection(0), 0);
  EXPECT_EQ(deflection(-3000), 0);
  EXPECT_EQ(deflection(32767), 1);
  EXPECT_EQ(deflection(-32768), -1);
  EXPECT_GT(deflection(20000), deflection(10000));
}

}  // namespace
}  // namespace cloudscape::viewer
