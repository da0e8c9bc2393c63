// What homogeneous media let through, against exp(-optical depth) of the path's exact length.
#include "fixture.h"

namespace cloudscape::render {
namespace {

constexpr double tolerance = 1e-3;  // of the transmittance; the march gives up below 0.003
using Transmittance = RenderTest;

void expect_transmittance(const Frame& frame, double optical_depth, const std::string& what) {
  EXPECT_NEAR(1 - opacity(frame), std::exp(-optical_depth), tolerance) << what;
}

TEST_F(Transmittance, OfASlabByTheSlant) {
  const Cloudscape sky = homogeneous(VolumeKind::slab, {0, 0, 2000}, {1000, 1000, 500}, 1.2 / 500);
  for (const double elevation_deg : {90.0, 60.0, 37.0, 20.0})
    for (const double azimuth_deg : {0.0, 111.0})
      expect_transmittance(render(one_ray(sky, {camera_m, azimuth_deg, elevation_deg, 0})),
                           1.2 / std::sin(radians(elevation_deg)), "up at " + std::to_string(elevation_deg));
  expect_transmittance(render(one_ray(sky, {{0, 0, 5000}, 0, -50, 0})), 1.2 / std::sin(radians(50)), "down");
  expect_transmittance(render(one_ray(sky, {{0, 0, 2400}, 0, 90, 0})), 1.2 * 100 / 500, "from inside");
  expect_transmittance(render(one_ray(sky, {camera_m, 0, -30, 0})), 0, "away from it");
}

TEST_F(Transmittance, OfASphereByTheImpactParameter) {
  const Cloudscape sky = ball(200, 2);
  for (const double impact : {0.0, 0.3, 0.7, 0.95, 1.05}) {
    const double azimuth_deg = degrees(std::asin(impact * 200 / 1000));
    const double half_chord = std::sqrt(std::max(0.0, 1 - impact * impact));
    expect_transmittance(render(one_ray(sky, {camera_m, azimuth_deg, 0, 0})), 2 * 2 * half_chord,
                         "impact parameter " + std::to_string(impact));
  }
}

TEST_F(Transmittance, OfAGaussianByTheErrorFunction) {
  const double s_m = 50, extinction_per_m = 0.01;
  const Cloudscape sky =
      homogeneous(VolumeKind::gaussian, ball_center_m - 4 * s_m, glm::dvec3(8 * s_m), extinction_per_m);
  const double straight = extinction_per_m * s_m * std::sqrt(2 * std::numbers::pi) * std::erf(4 / std::sqrt(2.0));
  expect_transmittance(render(one_ray(sky, {camera_m, 0, 0, 0})), straight, "through the middle");
  const glm::dvec3 beside_m = camera_m + glm::dvec3(70, 0, 0);
  expect_transmittance(render(one_ray(sky, {beside_m, 0, 0, 0})), straight * std::exp(-0.5 * 70 * 70 / (s_m * s_m)),
                       "70 m beside the middle");
}

TEST_F(Transmittance, OfABox) {
  const Cloudscape sky = homogeneous(VolumeKind::box, {-100, 900, 950}, {200, 300, 100}, 0.004);
  expect_transmittance(render(one_ray(sky, {camera_m, 0, 0, 0})), 0.004 * 300, "along it");
  expect_transmittance(render(one_ray(sky, {{0, 1000, 2000}, 0, -90, 0})), 0.004 * 100, "down through it");
  expect_transmittance(render(one_ray(sky, {{0, 1000, 1000}, 90, 0, 0})), 0.004 * 100, "from inside to the east");
  expect_transmittance(render(one_ray(sky, {{0, 750, 1000}, 20, 0, 0})),
                       0.004 * (100 / std::sin(radians(20)) - 150 / std::cos(radians(20))),
                       "in at the front, out at the side");
  expect_transmittance(render(one_ray(sky, {camera_m, 180, 0, 0})), 0, "behind the camera");
}

// The same optical depth in one step as in many, wherever in their steps the samples lie.
TEST_F(Transmittance, DoesNotDependOnTheNumberOfSteps) {
  for (const int steps : {1, 8, 64}) {
    FrameRequest request = one_ray(ball(200, 1), {camera_m, 0, 0, 0});
    request.size_px = {5, 3};
    request.lens = {LensKind::orthographic, 50, 1};  // parallel, and close to the middle: 1 m at most beside it
    request.quality.max_steps = steps;
    const Frame frame = render(request);
    for (int pixel = 0; pixel < 15; ++pixel)
      EXPECT_NEAR(1 - opacity(frame, pixel), std::exp(-2.0), 1e-4) << steps << " steps, pixel " << pixel;
  }
}

TEST_F(Transmittance, OfAThickMediumIsNothing) {
  EXPECT_EQ(opacity(render(one_ray(ball(200, 50), {camera_m, 0, 0, 0}))), 1);
}

}  // namespace
}  // namespace cloudscape::render
