// The volume of the clouds' depth towards the light: against closed forms and an independent march, and how it is
// baked.
#include "render/sun_depth.h"

#include "gpu/render/cloud_grid.h"
#include "render/block_values.h"

namespace cloudscape::render {
namespace {

constexpr int across = CloudDensities::across, layers = CloudDensities::layers;
constexpr int slices = layers / CloudDensities::layers_per_slice;  // one level: coverage is the same everywhere
constexpr double radius_m = 6360000;

// Between a point of this altitude and the top of the layer.
double metres_in_shell(double altitude_m, double top_m, double sine) {
  const double r = radius_m + altitude_m, out = radius_m + top_m;
  return std::sqrt(r * r * sine * sine + out * out - r * r) - r * sine;
}

struct Depths {
  explicit Depths(gpu::ShaderLibrary& shaders) : densities(shaders), depths(shaders, densities) {}
  CloudDensities densities;
  SunDepths depths;
};

class SunDepthTest : public CloudGridTest {
 protected:
  static FrameRequest request_of(const Cloudscape& sky, bool may_lag = false) {
    FrameRequest request = one_ray(sky, {{0, 0, 100}, 0, 0, 0});
    request.light_may_lag = may_lag;
    return request;
  }
  // Calls of `prepare` that it took; -1: more than there is to do.
  static int settle(Depths& of, const FrameRequest& request, std::shared_ptr<const gpu::Texture>& depth) {
    const auto baked = baked_of(*request.cloudscape);
    const CloudBlock cloud = cloud_block(request, *baked);
    for (int calls = 1; calls < 1000; ++calls)
      if (of.depths.prepare({request, cloud, baked}, depth)) return calls;
    return -1;
  }
  static std::vector<float> depth_m(const Cloudscape& sky) {
    Depths depths(stack().shaders);
    std::shared_ptr<const gpu::Texture> depth;
    EXPECT_GT(settle(depths, request_of(sky), depth), 1);
    return values_of(*depth);
  }
};

TEST_F(SunDepthTest, OfAFullLayerItIsTheWayThroughTheShell) {
  for (const double sun_deg : {70.0, 30.0, 5.0, 0.5}) {
    const std::vector<float> depth = depth_m(full_layer(sun_deg));
    for (const int layer : {0, 7, layers - 1}) {
      const double altitude_m = 1000 + 2000.0 * layer / (layers - 1);
      const double exact_m = metres_in_shell(altitude_m, 3000, std::sin(radians(sun_deg)));
      const auto cell = static_cast<std::size_t>((layer * across + 40) * across + 17);
      EXPECT_NEAR(depth[cell], exact_m, 0.002 * exact_m + 1e-3) << "sun " << sun_deg << ", layer " << layer;
    }
  }
}

// Detail included, which the volume has as a mean only. The last columns of the tile see over its edge.
TEST_F(SunDepthTest, OfBrokenCloudsItIsWhatAFineMarchSees) {
  for (const double sun_deg : {50.0, 15.0}) {
    const Cloudscape sky = broken_clouds(90, sun_deg);
    const auto baked = baked_of(sky);
    const Voxels voxels = voxels_of(DensityExport(stack().shaders, sky, *baked, 192));
    const CloudBlock cloud = cloud_block(request_of(sky), *baked);
    const std::vector<float> depth = depth_m(sky);
    const glm::dvec3 light = direction_of_light(sky);
    for (const int first : {0, across - 6}) {
      std::vector<double> seen, marched;
      for (int y = 0; y < across; y += 3)
        for (int x = first; x < (first == 0 ? across : across - 1); x += first == 0 ? 5 : 1) {
          const glm::dvec3 from_m((x + 0.5) / across * 8000, (y + 0.5) / across * 8000, double(cloud.march.z) - 1000);
          marched.push_back(voxels.march_m(from_m, light));
          seen.push_back(depth[static_cast<std::size_t>(y * across + x)]);
        }
      const Likeness like = likeness(seen, marched);
      EXPECT_GT(like.correlation, 0.96) << "sun " << sun_deg << ", from column " << first;
      EXPECT_NEAR(like.mean_ratio, 1, 0.1) << "sun " << sun_deg << ", from column " << first;
    }
  }
}

TEST_F(SunDepthTest, EverySliceIsAsLongAsTheOthersAndAMovedSunBakesNoDensity) {
  Depths depths(stack().shaders);
  std::shared_ptr<const gpu::Texture> first, second, again;
  EXPECT_EQ(settle(depths, request_of(broken_clouds(10, 40)), first), 2 * slices);
  EXPECT_EQ(depths.densities.slices(), slices);
  EXPECT_EQ(depths.depths.slices(), slices);
  EXPECT_EQ(settle(depths, request_of(broken_clouds(20, 30)), second), slices);
  EXPECT_EQ(depths.densities.slices(), slices);
  EXPECT_EQ(depths.depths.slices(), 2 * slices);
  EXPECT_EQ(settle(depths, request_of(broken_clouds(10, 40)), again), 1) << "it is kept";
  EXPECT_EQ(again, first);
  EXPECT_EQ(values_of(*second), depth_m(broken_clouds(20, 30))) << "the same bytes whatever came before";
}

TEST_F(SunDepthTest, AFrameThatMayLagTakesTheLastThatIsDoneAndIsRightOnceTheSunStands) {
  Depths depths(stack().shaders);
  std::shared_ptr<const gpu::Texture> before;
  settle(depths, request_of(broken_clouds(10, 40)), before);
  int waits = 0;
  for (int frame = 0; frame < 10; ++frame) {
    std::shared_ptr<const gpu::Texture> depth;
    const int done = depths.depths.slices();
    waits += settle(depths, request_of(broken_clouds(10 + frame, 40 - frame), true), depth) - 1;
    EXPECT_LE(depths.depths.slices(), done + 1) << "one slice a frame";
    if (frame == 1) {
      EXPECT_EQ(depth, before);
    }
    if (frame == 9) {
      EXPECT_NE(depth, before) << "a light on the way was baked to its end";
    }
  }
  EXPECT_EQ(waits, 0);
  std::shared_ptr<const gpu::Texture> settled;
  for (int frame = 0; frame < 10; ++frame) {
    settled.reset();
    settle(depths, request_of(broken_clouds(19, 31), true), settled);
  }
  EXPECT_EQ(values_of(*settled), depth_m(broken_clouds(19, 31)));
}

// Lit by nothing but the sun; a layer that stands alone over 8 km.
Cloudscape shaded_ground(bool clouds) {
  Cloudscape sky = full_layer(60);
  sky.sun.irradiance = glm::dvec3(1), sky.sun.disc = false;
  sky.sky.kind = SkyKind::none;
  sky.ground.kind = GroundKind::plain, sky.ground.albedo = glm::dvec3(0.5), sky.ground.variation = 0;
  sky.sun.azimuth_deg = 0;
  sky.volume.tiling = false;
  sky.medium.extinction_per_m = clouds ? 0.01 : 0;
  return sky;
}

TEST_F(SunDepthTest, GroundBehindALayerIsAsDarkAsTwoStreamsSay) {
  const auto ratio = [](const glm::dvec3& position_m) {
    const CameraPose down{position_m, 0, -89.9, 0};
    return red(render(one_ray(shaded_ground(true), down))) / red(render(one_ray(shaded_ground(false), down)));
  };
  const double depth = 0.01 * 2000 / std::sin(radians(60));
  const double g = shaded_ground(true).medium.phase.asymmetry_g;
  EXPECT_NEAR(ratio({4000, 4000, 500}), 1 / (1 + 0.75 * (1 - g) * depth), 0.005);
  EXPECT_NEAR(ratio({4000, 7900, 500}), 1, 1e-4) << "its light passes the edge";
  // Light that enters by the side, 1000 m away.
  const double side_depth = 0.01 * (3000 - 1000 * std::tan(radians(60))) / std::sin(radians(60));
  EXPECT_NEAR(ratio({4000, -1000, 500}), 1 / (1 + 0.75 * (1 - g) * side_depth), 0.01);
  EXPECT_NEAR(ratio({4000, -3000, 500}), 1, 1e-4) << "beside it";
}

// Air without haze over black ground, seen from beneath an endless layer through which hardly anything comes.
TEST_F(SunDepthTest, AirInTheShadowOfALayerLosesItsDirectHalf) {
  const auto radiance = [](bool clouds, const CameraPose& pose, bool tiling) {
    Cloudscape sky = full_layer(60);
    sky.sun.azimuth_deg = 0, sky.sun.disc = false;
    sky.sky.haze = 0;
    sky.ground.kind = GroundKind::plain, sky.ground.albedo = glm::dvec3(0);
    sky.volume.tiling = tiling;
    sky.medium.extinction_per_m = clouds ? 10 : 0;
    return red(render(one_beam(sky, pose)));
  };
  const CameraPose down{{4000, 4000, 800}, 0, -80, 0};
  EXPECT_NEAR(radiance(true, down, true) / radiance(false, down, true), 0.5, 0.01);
  // Beneath a layer alone: from 2 km before the end of its shadow to 2 km beyond it.
  const double shadow_ends_m = 8000 - 1000 / std::tan(radians(60));
  const CameraPose along{{4000, shadow_ends_m - 2000, 200}, 0, degrees(std::atan(-200.0 / 4000)), 0};
  EXPECT_NEAR(radiance(true, along, false) / radiance(false, along, false), 0.75, 0.03);
}

TEST_F(SunDepthTest, WithoutCloudsNothingIsInTheirShadow) {
  for (const bool formula : {false, true}) {
    Cloudscape sky = small_clouds(), empty = sky;
    if (formula) sky = homogeneous(VolumeKind::box, {0, 90000, 0}, {10, 10, 10}, 1), sky.sky.kind = SkyKind::clear;
    sky.shape.threshold = 10;
    empty = sky, empty.medium.extinction_per_m = 0;
    const auto picture = [](const Cloudscape& shown) {
      FrameRequest request = one_ray(shown, {{0, 0, 300}, 40, 5, 0});
      request.size_px = {32, 18};
      return render(request).radiance_rgba;
    };
    EXPECT_EQ(picture(sky), picture(empty));
  }
}

}  // namespace
}  // namespace cloudscape::render
