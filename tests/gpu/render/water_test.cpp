// Water: where it lies, what it mirrors, and that frames with it stay functions of their requests.
#include <algorithm>

#include "fixture.h"
#include "render/water_stage.h"
#include "tests/height_maps.h"

namespace cloudscape::render {
namespace {

constexpr double planet_m = 6360000;

double fresnel(double elevation_deg) {
  const double in = radians(90 - elevation_deg), out = std::asin(std::sin(in) / 1.333);
  return 0.5 *
         (std::pow(std::sin(in - out) / std::sin(in + out), 2) + std::pow(std::tan(in - out) / std::tan(in + out), 2));
}

// Calm, and black below.
Cloudscape with_water(Cloudscape sky, double level_m, double wind_m_per_s = 0) {
  sky.ground.water.level_m = level_m;
  sky.ground.water.wind_m_per_s = wind_m_per_s;
  sky.ground.water.albedo = glm::dvec3(0);
  return sky;
}

using Sea = RenderTest;

TEST(WaterWind, MakesTheSlopesOfCoxAndMunk) {
  EXPECT_EQ(mean_square_slope(0), 0);
  EXPECT_NEAR(mean_square_slope(10), 0.003 + 0.0512, 1e-9);
}

TEST_F(Sea, LiesAtItsLevelWhateverTheGround) {
  for (const GroundKind kind : {GroundKind::none, GroundKind::plain})
    for (const double level_m : {0.0, 400.0}) {
      Cloudscape sky = with_water(empty_world(), level_m);
      sky.ground.kind = kind;
      EXPECT_NEAR(depth_m(render(one_ray(sky, {{0, 0, 1000}, 0, -90, 0}))), 1000 - level_m, 0.1);
      // 5 degrees down: a chord of the sphere.
      const double b = (planet_m + 1000) * std::sin(radians(5)), r = planet_m + level_m;
      const double chord_m = b - std::sqrt(b * b - (planet_m + 1000) * (planet_m + 1000) + r * r);
      EXPECT_NEAR(depth_m(render(one_ray(sky, {{0, 0, 1000}, 30, -5, 0}))), chord_m, 1e-3 * chord_m);
      EXPECT_TRUE(std::isinf(depth_m(render(one_ray(sky, {{0, 0, 1000}, 0, 1, 0})))));
    }
}

TEST_F(Sea, MirrorsTheSkyThatStandsThere) {
  const Cloudscape sky = with_water(clear_world(35), 0);
  for (const double azimuth_deg : {90.0, 170.0, 250.0})
    for (const double elevation_deg : {8.0, 20.0, 50.0}) {
      const Frame above = render(one_ray(sky, {{0, 0, 2}, azimuth_deg, elevation_deg, 0}));
      const Frame below = render(one_ray(sky, {{0, 0, 2}, azimuth_deg, -elevation_deg, 0}));
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(below.radiance_rgba[i] / (fresnel(elevation_deg) * above.radiance_rgba[i]), 1, 0.03)
            << azimuth_deg << ", " << elevation_deg << ", channel " << i;
    }
}

// From any height: no dark line between a calm sea and the sky.
TEST_F(Sea, MeetsTheSkyWithoutASeam) {
  for (const double altitude_m : {1.0, 300.0, 20000.0}) {
    const double dip_deg = degrees(std::acos(planet_m / (planet_m + altitude_m)));
    FrameRequest request = picture(with_water(clear_world(35), 0), {{0, 0, altitude_m}, 120, -dip_deg, 0}, {1, 80});
    request.lens.vertical_fov_deg = 2;
    const Frame frame = render(request);
    for (int row = 1; row < 80; ++row)
      EXPECT_NEAR(red(frame, row) / red(frame, row - 1), 1, 0.12) << altitude_m << ", row " << row;
  }
}

// Straight down on a ruffled sea below a sun overhead: the density of level facets, times what they reflect.
TEST_F(Sea, GlittersAsItsSlopesAreSpread) {
  Cloudscape sky = with_water(empty_world(), 0, 7);
  sky.sun.elevation_deg = 90;
  FrameRequest request = picture(sky, {{0, 0, 20000}, 0, -90, 0}, {32, 32});
  request.lens = {LensKind::orthographic, 50, 16000};
  const Frame frame = render(request);
  double mean = 0;
  for (int pixel = 0; pixel < 32 * 32; ++pixel) mean += red(frame, pixel) / (32 * 32);
  const double mss = mean_square_slope(7);
  EXPECT_NEAR(mean / (fresnel(89.999) / (4 * std::numbers::pi * mss)), 1, 0.15) << "gusts make some of it rougher";
}

TEST_F(Sea, DoesNotGlitterBelowThickCloud) {
  Cloudscape sky = with_water(homogeneous(VolumeKind::slab, {-1e6, -1e6, 500}, {2e6, 2e6, 500}, 0.1), 0, 5);
  sky.medium.single_scattering_albedo = 0;
  sky.sun.elevation_deg = 40;
  Cloudscape bare = sky;
  bare.medium.extinction_per_m = 0;
  const CameraPose pose{{0, 0, 50}, sky.sun.azimuth_deg, -40, 0};
  EXPECT_GT(red(render(one_ray(bare, pose))), 0.01);
  EXPECT_LT(red(render(one_ray(sky, pose))), 1e-6);
}

FrameRequest cloudy_sea() {
  Cloudscape sky = small_clouds();
  sky.ground.water.level_m = 0;
  FrameRequest request = picture(sky, {{0, 0, 100}, 20, -12, 0}, {48, 27});
  request.quality.float32 = false;
  return request;
}

TEST_F(Sea, IsTheSameWhateverWasRenderedBefore) {
  const Frame first = render(cloudy_sea());
  FrameRequest other = cloudy_sea();
  other.pose.position_m += glm::dvec3(40000, 7000, 500), other.time_s = 900;
  const Frame elsewhere = render(other);
  EXPECT_NE(elsewhere.radiance_rgba, first.radiance_rgba);
  EXPECT_EQ(render(cloudy_sea()).radiance_rgba, first.radiance_rgba);
  EXPECT_EQ(render(other).radiance_rgba, elsewhere.radiance_rgba);
}

TEST_F(Sea, TakesItsPanoramaOfCloudsAgainOnlyWhereTheCloudsAreOthers) {
  FrameRequest request = cloudy_sea();
  render(request);
  const int before = renderer().panoramas();
  request.pose.position_m += glm::dvec3(8, -5, 300), request.pose.azimuth_deg = 200;
  request.stream = next_stream();
  render(request);
  // The wind takes clouds and camera along.
  request.time_s = 1000;
  const Wind& wind = request.cloudscape->wind;
  const double azimuth = radians(wind.towards_azimuth_deg), way_m = wind.speed_m_per_s * request.time_s;
  request.pose.position_m += way_m * glm::dvec3(std::sin(azimuth), std::cos(azimuth), 0);
  render(request);
  EXPECT_EQ(renderer().panoramas(), before);
  request.pose.position_m.x += 5000;
  render(request);
  EXPECT_EQ(renderer().panoramas(), before + 1);
}

TEST_F(Sea, MovesItsWavesWithTime) {
  FrameRequest request = picture(with_water(clear_world(35), 0, 6), {{0, 0, 5}, 90, -30, 0}, {32, 18});
  const Frame first = render(request);
  request.time_s = 0.5;
  EXPECT_NE(render(request).radiance_rgba, first.radiance_rgba);
}

constexpr int side = 256;
constexpr double size_m = 16384, spacing_m = size_m / side;

class Lake : public OwnStackTest {
 protected:
  Lake() {
    std::vector<float> heights;  // a hill in the middle
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column) {
        const double away_m = spacing_m * std::hypot(column - side / 2, row - side / 2);
        heights.push_back(static_cast<float>(1000 * std::exp(-away_m * away_m / (2 * 900.0 * 900.0))));
      }
    folder_.write_exr("hill.exr", side, side, heights);
    stack_ = std::make_unique<Stack>(gpu::PassExecution::automatic, folder_.path());
  }
  double seen(const CameraPose& pose) {
    Cloudscape sky = with_water(empty_world(), 100);
    sky.sky = {SkyKind::uniform, glm::dvec3(1)};
    sky.sun.irradiance = glm::dvec3(0);
    sky.ground.kind = GroundKind::terrain;
    sky.ground.albedo = glm::dvec3(0), sky.ground.variation = 0;
    sky.ground.terrain = {.height_map = "hill.exr",
                          .resolution = side,
                          .size_m = size_m,
                          .origin_m = glm::dvec2(-size_m / 2),
                          .height_m = 1,
                          .tiling = false,
                          .snow_line_m = 20000,
                          .tree_line_m = 20000,
                          .rock_albedo = glm::dvec3(0)};
    FrameRequest request = one_ray(sky, pose);
    request.lens.vertical_fov_deg = 1;  // a pixel as wide as a mountain sees none
    return red(stack_->renderer.render(request));
  }
  HeightMapFolder folder_;
  std::unique_ptr<Stack> stack_;
};

// A black hill, 900 m above a lake that mirrors a white sky.
TEST_F(Lake, MirrorsTheLandBehindIt) {
  const glm::dvec3 camera(0, -5000, 110);
  EXPECT_NEAR(seen({camera, 180, -6, 0}) / fresnel(6), 1, 0.03) << "away from the hill: sky";
  EXPECT_NEAR(seen({camera, 0, -25, 0}) / fresnel(25), 1, 0.03) << "above its top: sky";
  EXPECT_LT(seen({camera, 0, -6, 0}) / fresnel(6), 0.05) << "the hill";
  EXPECT_NEAR(seen({camera, 0, 6, 0}), 0, 0.02) << "the hill itself";
}

}  // namespace
}  // namespace cloudscape::render
