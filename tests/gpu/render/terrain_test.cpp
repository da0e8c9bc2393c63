// Terrains of known shape: where rays meet them, what hides what, and where shadows end.
#include <algorithm>

#include "core/error.h"
#include "fixture.h"
#include "tests/height_maps.h"

namespace cloudscape::render {
namespace {

constexpr double planet_m = 6360000;
constexpr int side = 512;
constexpr double size_m = 16384, spacing_m = size_m / side;  // 32 m; the middle point is the world's origin

double hill_m(double east_m, double north_m) {
  return 1000 * std::exp(-(east_m * east_m + north_m * north_m) / (2 * 900.0 * 900.0));
}
double wall_m(double, double north_m) { return north_m == 0 ? 500 : 0; }

// `height_m` at the lattice's points, as an EXR, which has its north at the top.
std::vector<float> map_of(double (*height_m)(double, double)) {
  std::vector<float> heights;
  for (int row = side - 1; row >= 0; --row)
    for (int column = 0; column < side; ++column)
      heights.push_back(static_cast<float>(height_m((column - side / 2) * spacing_m, (row - side / 2) * spacing_m)));
  return heights;
}

class Terrains : public OwnStackTest {
 protected:
  Terrains() {
    if (own_) return;
    own_ = std::make_unique<StackOfMaps>();
    own_->folder.write_exr("hill.exr", side, side, map_of(hill_m));
    own_->folder.write_exr("wall.exr", side, side, map_of(wall_m));
    own_->folder.write_exr("plain.exr", 2, 2, {0, 0, 0, 0});
  }
  static void TearDownTestSuite() { own_.reset(); }
  static Cloudscape land(const std::string& height_map) {
    Cloudscape sky = empty_world();
    sky.ground.kind = GroundKind::terrain;
    sky.ground.variation = 0;
    Terrain& terrain = sky.ground.terrain;
    terrain.height_map = height_map;
    terrain.resolution = side;
    terrain.size_m = size_m;
    terrain.origin_m = glm::dvec2(-size_m / 2);
    terrain.height_m = 1;  // the maps are in metres
    terrain.tiling = false;
    return sky;
  }
  // Parallel rays `width_m` / `size.width` apart.
  static FrameRequest beams(const Cloudscape& sky, const CameraPose& pose, ImageSize size_px, double width_m) {
    FrameRequest request = picture(sky, pose, size_px);
    request.lens = {LensKind::orthographic, 50, width_m};
    return request;
  }
  static Frame render(const FrameRequest& request) {
    Frame frame = renderer().render(request);
    renderer().forget(request.stream);
    return frame;
  }
  static HeightMapFolder& folder() { return own_->folder; }
  static Renderer& renderer() { return own_->stack.renderer; }

 private:
  struct StackOfMaps {
    HeightMapFolder folder;
    Stack stack{gpu::PassExecution::automatic, folder.path()};
  };
  static inline std::unique_ptr<StackOfMaps> own_;
};

double altitude_m(const glm::dvec3& p) { return std::hypot(p.x, p.y, p.z + planet_m) - planet_m; }

TEST_F(Terrains, AreMetWhereTheirSurfaceIs) {
  const glm::dvec3 camera(0, -5000, 1100);
  int land_pixels = 0;
  for (const double azimuth_deg : {-12.0, 0.0, 9.0}) {
    FrameRequest request = picture(land("hill.exr"), {camera, azimuth_deg, -8, 0}, {1, 64});
    request.lens.vertical_fov_deg = 16;
    const Frame frame = render(request);
    for (int pixel = 0; pixel < 64; ++pixel) {
      const double up = std::tan(radians(8)) * (1 - (pixel + 0.5) / 32), azimuth = radians(azimuth_deg);
      const double level = std::cos(radians(8)) + up * std::sin(radians(8));
      const double rise = -std::sin(radians(8)) + up * std::cos(radians(8));
      const glm::dvec3 direction =
          glm::normalize(glm::dvec3(std::sin(azimuth) * level, std::cos(azimuth) * level, rise));
      const double hit_m = depth_m(frame, pixel);
      const glm::dvec3 origin(0, 0, camera.z);  // the planet's top is below the camera
      const auto at = [&](double t) { return origin + direction * t + glm::dvec3(camera.x, camera.y, 0); };
      const auto clear_at = [&](double t) { return altitude_m(origin + direction * t) - hill_m(at(t).x, at(t).y); };
      const double end_m = std::isinf(hit_m) ? 20000 : hit_m;
      // Bilinear between points 32 m apart, of a surface that bends by 1000 / 900^2 a metre: 0.16 m; and floats.
      if (std::isfinite(hit_m)) {
        EXPECT_NEAR(clear_at(hit_m), 0, 0.5) << azimuth_deg << ", " << pixel;
        ++land_pixels;
      }
      for (double t = 0; t < end_m - 5; t += 5) ASSERT_GT(clear_at(t), -0.5) << "went through at " << t << " m";
    }
  }
  EXPECT_GT(land_pixels, 100);
}

// Parallel rays begin elsewhere than at the camera; so do paths that are traced on.
TEST_F(Terrains, AreMetByParallelRays) {
  const Frame frame = render(beams(land("hill.exr"), {{0, 0, 5000}, 0, -90, 0}, {225, 1}, 3600));
  for (int pixel = 0; pixel < 225; ++pixel)
    EXPECT_NEAR(depth_m(frame, pixel), 5000 - hill_m((pixel - 112) * 16, 0), 3) << pixel;
}

TEST_F(Terrains, HaveNoHolesInTheirNarrowestRidge) {
  // One lattice point wide, 4 km away, seen by rays 5 m apart.
  const Frame frame = render(beams(land("wall.exr"), {{0, -4000, 245}, 0, 0, 0}, {200, 100}, 1000));
  for (int pixel = 0; pixel < 200 * 100; ++pixel) {
    const double altitude = 245 + (49.5 - pixel / 200) * 5 - 0.5 * 4000 * 4000 / planet_m;
    if (altitude > 10 && altitude < 495) {
      EXPECT_NEAR(depth_m(frame, pixel), 4000, spacing_m) << pixel;
    }
  }
  EXPECT_TRUE(std::isinf(depth_m(render(beams(land("wall.exr"), {{0, -4000, 510}, 0, 0, 0}, {1, 1}, 1)))));
}

TEST_F(Terrains, BeyondTheHorizonAreHiddenUpToTheRightHeight) {
  constexpr double camera_m = 10, distance_m = 60000;
  FrameRequest request = picture(land("wall.exr"), {{0, -distance_m, camera_m}, 0, 0, 0}, {1, 400});
  request.lens.vertical_fov_deg = 1;  // 400 pixels: 2.6 m each at the wall
  const Frame frame = render(request);
  const double horizon_m = std::sqrt(2 * planet_m * camera_m);
  const double hidden_m = (distance_m - horizon_m) * (distance_m - horizon_m) / (2 * planet_m);
  std::vector<double> heights_m;
  for (int pixel = 0; pixel < 400; ++pixel) {
    const double angle = std::atan(std::tan(radians(0.5)) * (1 - (pixel + 0.5) / 200));
    if (std::abs(depth_m(frame, pixel) - distance_m) > 200) continue;
    heights_m.push_back(camera_m + distance_m * std::tan(angle) + distance_m * distance_m / (2 * planet_m));
  }
  ASSERT_GT(heights_m.size(), 50U);
  EXPECT_NEAR(heights_m.back(), hidden_m, 6) << "of " << hidden_m << " m that the sea hides";
  EXPECT_NEAR(heights_m.front(), 500, 6);
}

TEST_F(Terrains, CastShadowsThatEndWhereTheSunComesOverThem) {
  for (const double elevation_deg : {10.0, 20.0, 45.0}) {
    Cloudscape sky = land("wall.exr");
    sky.sun.azimuth_deg = 180, sky.sun.elevation_deg = elevation_deg;
    sky.sun.angular_radius_deg = 0.01;  // no penumbra
    const double length_m = 500 / std::tan(radians(elevation_deg));
    // Straight down, 10 m a pixel, north up; the wall in the middle of the picture.
    const Frame frame = render(beams(sky, {{0, 0, 5000}, 0, -90, 0}, {8, 700}, 80));
    int dark = 0;
    const auto north_m = [](int row) { return (349.5 - row) * 10; };
    const double lit = red(frame, 8 * 690);
    ASSERT_GT(lit, 0);
    for (int row = 0; row < 350; ++row) {
      const double share = red(frame, 8 * row) / lit;
      if (north_m(row) > 2 * spacing_m && north_m(row) < length_m - 2 * spacing_m) {
        EXPECT_LT(share, 0.03) << row << ": the sunlit land around shines into it, but no more";
        ++dark;
      }
      if (north_m(row) > length_m + 2 * spacing_m) {
        EXPECT_GT(share, 0.3) << row << ": stones shade each other, but not that much";
      }
    }
    EXPECT_GT(dark, 20);
  }
}

// A moving picture is not kept waiting by the shadows of a sun that turns, and has them once it stands.
TEST_F(Terrains, OfMovingPicturesHaveTheShadowsOfAMomentAgo) {
  Cloudscape sky = land("hill.exr");
  sky.sun.elevation_deg = 15;
  const auto seen = [&](double azimuth_deg, bool may_lag) {
    sky.sun.azimuth_deg = azimuth_deg;
    FrameRequest request = beams(sky, {{0, 0, 5000}, 0, -90, 0}, {64, 64}, 6000);
    request.light_may_lag = may_lag;
    int steps = 1;
    const std::unique_ptr<RenderJob> job = renderer().begin(request);
    while (!renderer().advance(*job)) ++steps;
    const std::shared_ptr<const gpu::Texture> shadows = job->land.sun;
    return std::pair(steps, shadows);
  };
  const auto first = seen(100, false), second = seen(100, true);
  EXPECT_EQ(second.second, first.second) << "it is kept";
  const auto turned = seen(190, true);
  EXPECT_EQ(turned.first, second.first) << "a frame waited";
  std::shared_ptr<const gpu::Texture> last = turned.second;
  for (int frame = 0; frame < 1000 && last == first.second; ++frame) last = seen(190, true).second;
  EXPECT_NE(last, first.second);
  const auto still = seen(190, false);
  EXPECT_EQ(still.second, last);
}

TEST_F(Terrains, HideCloudsBehindThemAndNotBeforeThem) {
  const auto seen = [&](double north_m) {
    Cloudscape sky = land("wall.exr");
    sky.volume.kind = VolumeKind::sphere;
    sky.volume.origin_m = glm::dvec3(-100, north_m - 100, 150), sky.volume.size_m = glm::dvec3(200);
    sky.medium.extinction_per_m = 0.1;
    return render(beams(sky, {{0, -3000, 250}, 0, 0, 0}, {1, 1}, 1));
  };
  const Frame before = seen(-1000), behind = seen(1000);
  EXPECT_GT(opacity(before), 0.99);
  EXPECT_NEAR(depth_m(before), 1900, 15);
  EXPECT_EQ(opacity(behind), 0);
  EXPECT_NEAR(depth_m(behind), 3000, spacing_m);
}

TEST_F(Terrains, EndACloudThatTheyStandIn) {
  Cloudscape sky = land("wall.exr");
  sky.volume.kind = VolumeKind::box;
  sky.volume.origin_m = glm::dvec3(-500, -1000, 0), sky.volume.size_m = glm::dvec3(1000, 3000, 450);
  sky.medium.extinction_per_m = 1e-3;
  const Frame frame = render(beams(sky, {{0, -3000, 250}, 0, 0, 0}, {1, 1}, 1));
  EXPECT_NEAR(opacity(frame), 1 - std::exp(-1.0), 0.03) << "a kilometre of it, of three";
}

// A map of no height is the plain.
TEST_F(Terrains, ThatAreLevelAreLambertian) {
  Cloudscape sky = land("plain.exr");
  sky.ground.albedo = {0.3, 0.5, 0.7};
  sky.sun.elevation_deg = 30;
  const Frame flat = render(beams(sky, {{0, 0, 1000}, 0, -90, 0}, {1, 1}, 1));
  EXPECT_NEAR(red(flat), 0.3 / std::numbers::pi * 0.5, 1e-3);
  EXPECT_NEAR(depth_m(flat), 1000, 0.1);
  const Frame outside = render(beams(sky, {{50000, 0, 1000}, 0, -90, 0}, {1, 1}, 1));
  EXPECT_NEAR(red(outside), red(flat), 1e-4) << "outside the map there is the plain";
  sky.ground.terrain.base_m = 300;
  EXPECT_NEAR(depth_m(render(beams(sky, {{0, 0, 1000}, 0, -90, 0}, {1, 1}, 1))), 700, 0.1);
  EXPECT_NEAR(depth_m(render(beams(sky, {{50000, 0, 1000}, 0, -90, 0}, {1, 1}, 1))), 700, 0.1);
}

TEST_F(Terrains, RepeatWhereTheyTile) {
  Cloudscape sky = land("hill.exr");
  sky.ground.terrain.tiling = true;
  const CameraPose pose{{100, -5000, 1100}, 5, -5, 0};
  CameraPose far = pose;
  far.position_m += glm::dvec3(3 * size_m, -700 * size_m, 0);
  const Frame here = render(picture(sky, pose, {32, 24})), there = render(picture(sky, far, {32, 24}));
  for (int pixel = 0; pixel < 32 * 24; ++pixel)
    if (depth_m(here, pixel) < 8000) {
      EXPECT_NEAR(depth_m(there, pixel) / depth_m(here, pixel), 1, 2e-3) << pixel;
    }
  EXPECT_LT(depth_m(here, 32 * 12 + 16), 8000);
}

TEST_F(Terrains, LetACameraInsideThemLookOut) {
  for (const double elevation_deg : {-90.0, -30.0, 0.0, 30.0, 90.0}) {
    const Frame frame = render(picture(land("hill.exr"), {{0, 0, 500}, 0, elevation_deg, 0}, {16, 9}));
    for (const float value : frame.radiance_rgba) EXPECT_TRUE(std::isfinite(value) && value >= 0);
    for (const float value : frame.depth_m) EXPECT_GE(value, 0);
  }
  EXPECT_TRUE(std::isinf(depth_m(render(beams(land("hill.exr"), {{0, 0, 500}, 0, 90, 0}, {1, 1}, 1)))));
}

TEST_F(Terrains, OfNoiseDependOnTheirSeedAlone) {
  Cloudscape sky = empty_world();
  sky.ground.kind = GroundKind::terrain;
  sky.ground.terrain.resolution = 128;
  const CameraPose pose{{0, 0, 3000}, 30, -20, 0};
  const Frame once = render(picture(sky, pose, {32, 18}));
  EXPECT_EQ(once.depth_m, render(picture(sky, pose, {32, 18})).depth_m);
  sky.ground.terrain.seed = 1;
  EXPECT_NE(once.depth_m, render(picture(sky, pose, {32, 18})).depth_m);
}

TEST_F(Terrains, ThatCannotBeReadAreToldAndTheNextFrameIsRendered) {
  folder().write("text.png", "no picture");
  for (const char* name : {"none.png", "text.png", "none.png"}) {
    auto job = renderer().begin(picture(land(name), {camera_m, 0, 0, 0}, {8, 8}));
    const auto finish = [&] {
      while (!renderer().advance(*job)) {
      }
    };
    EXPECT_THROW(finish(), Error) << name;
    renderer().abandon(std::move(job));
  }
  EXPECT_GT(red(render(beams(land("plain.exr"), {camera_m, 0, -90, 0}, {1, 1}, 1))), 0);
  folder().write_exr("none.exr", 2, 2, {0, 0, 0, 0});
  EXPECT_GT(red(render(beams(land("none.exr"), {camera_m, 0, -90, 0}, {1, 1}, 1))), 0) << "it is there now";
}

// The noise of their heights is kept on disk.
class KeptTerrains : public OwnStackTest {};

TEST_F(KeptTerrains, ComeBackInAnotherProgram) {
  const HeightMapFolder folder;
  const auto rendered = [&] {
    gpu::Context context({});
    gpu::ShaderLibrary shaders;
    bake::BakeStore bakes(context, shaders, bake::BakeCache(folder.path(), 1 << 28), std::uint64_t{1} << 28);
    Renderer another(context, shaders, bakes);
    Cloudscape sky = empty_world();
    sky.ground.kind = GroundKind::terrain;
    sky.ground.terrain.resolution = 64;
    return another.render(picture(sky, {{0, 0, 5000}, 0, -90, 0}, {32, 32})).radiance_rgba;
  };
  const auto files = [&] {
    return std::count_if(std::filesystem::directory_iterator(folder.path()), {},
                         [](const auto& entry) { return entry.path().extension() == ".relief"; });
  };
  const std::vector<float> baked = rendered();
  EXPECT_EQ(files(), 1);
  EXPECT_EQ(rendered(), baked);
  EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace cloudscape::render
