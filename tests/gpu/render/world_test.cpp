// The planet, the sky and the sun: horizon, distances, what hides what, and radiance in its unit.
#include "fixture.h"

namespace cloudscape::render {
namespace {

using World = RenderTest;
constexpr double planet_m = 6360000;

Cloudscape bare_planet() {
  Cloudscape sky = empty_world();
  sky.ground.kind = GroundKind::plain;
  return sky;
}

double dip_deg(double altitude_m) { return degrees(std::acos(planet_m / (planet_m + altitude_m))); }

TEST_F(World, HorizonLiesAtTheDipAngle) {
  for (const double altitude_m : {2.0, 100.0, 10000.0, 100000.0}) {
    // Two degrees high, 200 pixels: a hundredth of a degree each.
    FrameRequest request = picture(bare_planet(), {{0, 0, altitude_m}, 70, -dip_deg(altitude_m), 0}, {1, 200});
    request.lens.vertical_fov_deg = 2;
    const Frame frame = render(request);
    int sky_pixels = 0;
    while (sky_pixels < 200 && std::isinf(depth_m(frame, sky_pixels))) ++sky_pixels;
    EXPECT_NEAR(sky_pixels, 100, 1) << altitude_m;
    for (int pixel = sky_pixels; pixel < 200; ++pixel) ASSERT_TRUE(std::isfinite(depth_m(frame, pixel)));
    const double horizon_m = std::sqrt(altitude_m * (2 * planet_m + altitude_m));
    EXPECT_LT(depth_m(frame, sky_pixels), horizon_m * 1.0001) << altitude_m;
  }
}

TEST_F(World, DepthOfTheGroundIsTheDistanceAlongTheRay) {
  for (const double altitude_m : {3.0, 1000.0, 250000.0})
    EXPECT_NEAR(depth_m(render(one_ray(bare_planet(), {{3e5, -7e5, altitude_m}, 0, -90, 0}))) / altitude_m, 1, 1e-5);
  // The chord: h = s sin(e) - (s cos(e))^2 / 2R + ...; solved exactly.
  const double b = (planet_m + 1000) * std::sin(radians(10));
  const double chord_m = b - std::sqrt(b * b - 1000 * (2 * planet_m + 1000));
  EXPECT_NEAR(depth_m(render(one_ray(bare_planet(), {camera_m, 33, -10, 0}))) / chord_m, 1, 1e-5);
}

TEST_F(World, DepthOfACloudIsWhereItIs) {
  EXPECT_NEAR(depth_m(render(one_ray(ball(100, 200), {camera_m, 0, 0, 0}))), 900, 1);
  EXPECT_TRUE(std::isinf(depth_m(render(one_ray(ball(100, 200), {camera_m, 90, 0, 0})))));
}

TEST_F(World, GroundHidesWhatLiesBehindItAndNotWhatLiesBefore) {
  const auto seen = [](GroundKind ground, const glm::dvec3& center_m, double elevation_deg) {
    Cloudscape sky = homogeneous(VolumeKind::sphere, center_m - 500.0, glm::dvec3(1000), 0.1);
    sky.ground.kind = ground;
    return render(one_ray(sky, {{0, 0, 2}, 0, elevation_deg, 0}));
  };
  const glm::dvec3 behind_m(0, 100000, -1500);  // the curve of the ground is 785 m below the plane there
  const double down_deg = degrees(std::atan(-1502 / 100000.0));
  EXPECT_GT(opacity(seen(GroundKind::none, behind_m, down_deg)), 0.99);
  EXPECT_EQ(opacity(seen(GroundKind::plain, behind_m, down_deg)), 0);
  Cloudscape sky = homogeneous(VolumeKind::sphere, glm::dvec3(0, 1000, 100) - 50.0, glm::dvec3(100), 1);
  sky.ground.kind = GroundKind::plain;
  const Frame before = render(one_ray(sky, {camera_m, 0, -degrees(std::atan(0.9)), 0}));
  EXPECT_GT(opacity(before), 0.99);
  EXPECT_NEAR(depth_m(before), std::hypot(1000.0, 900.0) - 50, 3);
}

TEST_F(World, AUniformSkyHasItsRadianceEverywhere) {
  Cloudscape sky = empty_world();
  sky.sky.kind = SkyKind::uniform;
  sky.sky.radiance = {0.25, 0.5, 3};
  for (const double elevation_deg : {-80.0, 0.0, 90.0}) {
    const Frame frame = render(one_ray(sky, {camera_m, 12, elevation_deg, 0}));
    EXPECT_EQ(frame.radiance_rgba, (std::vector<float>{0.25F, 0.5F, 3.0F, 0.0F}));
  }
}

// A black planet aside, level ground under a uniform sky reflects albedo times the sky, and albedo / pi times the sun.
TEST_F(World, GroundIsLambertian) {
  Cloudscape sky = bare_planet();
  sky.ground.albedo = {0.3, 0.5, 0.7};
  sky.ground.variation = 0;
  sky.sun.elevation_deg = 30;
  EXPECT_NEAR(red(render(one_ray(sky, {camera_m, 0, -90, 0}))), 0.3 / std::numbers::pi * 0.5, 1e-4);
  sky.sun.irradiance = glm::dvec3(0);
  sky.sky.kind = SkyKind::uniform;
  sky.sky.radiance = glm::dvec3(2);
  EXPECT_NEAR(red(render(one_ray(sky, {camera_m, 0, -90, 0}))), 0.3 * 2, 0.005);
}

TEST_F(World, TheSunsDiscCarriesItsIrradiance) {
  for (const double radius_deg : {0.05, 0.268, 2.0}) {
    Cloudscape sky = empty_world();
    sky.sun.disc = true;
    sky.sun.angular_radius_deg = radius_deg;
    sky.sun.elevation_deg = 25, sky.sun.azimuth_deg = 200;
    const int side_px = 160;
    FrameRequest request = picture(sky, {camera_m, 200, 25, 0}, {side_px, side_px});
    request.lens.vertical_fov_deg = std::max(1.0, 3 * radius_deg);
    request.quality.samples = 8;
    const Frame frame = render(request);
    const double pixel = 2 * std::tan(radians(request.lens.vertical_fov_deg / 2)) / side_px;
    double irradiance = 0;
    for (int y = 0; y < side_px; ++y)
      for (int x = 0; x < side_px; ++x) {
        const double tangent2 =
            pixel * pixel * (std::pow(x + 0.5 - side_px / 2, 2) + std::pow(y + 0.5 - side_px / 2, 2));
        irradiance += red(frame, y * side_px + x) * pixel * pixel / std::pow(1 + tangent2, 1.5);
      }
    EXPECT_NEAR(irradiance, 1, 0.02) << "radius " << radius_deg;
  }
}

// A preset's whole light: sun, sky, ground and cloud are all proportional to the sun.
TEST_F(World, TwiceTheSunIsTwiceTheRadiance) {
  Cloudscape sky = small_clouds();
  const CameraPose pose{{0, 0, 500}, 100, 8, 0};
  const Frame once = render(picture(sky, pose, {12, 8}));
  sky.sun.irradiance *= 2;
  const Frame twice = render(picture(sky, pose, {12, 8}));
  for (std::size_t i = 0; i < once.radiance_rgba.size(); ++i) {
    const double expected = (i % 4 == 3 ? 1 : 2) * once.radiance_rgba[i];
    EXPECT_NEAR(twice.radiance_rgba[i], expected, 2e-3 * expected + 1e-6) << "channel " << i;
  }
}

TEST_F(World, SunsTooStrongForHalvesStayFinite) {
  Cloudscape sky = small_clouds();
  sky.sun.irradiance = glm::dvec3(500);
  sky.sun.angular_radius_deg = 0.1;
  sky.sun.azimuth_deg = 0, sky.sun.elevation_deg = 30;
  FrameRequest request = picture(sky, {{0, 0, 500}, 0, 30, 0}, {16, 16});
  request.lens.vertical_fov_deg = 2;
  request.quality.float32 = false;
  const Frame frame = render(request);
  for (const float value : frame.radiance_rgba) EXPECT_TRUE(std::isfinite(value));
}

}  // namespace
}  // namespace cloudscape::render
