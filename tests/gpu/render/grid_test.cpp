// Volumes from files: against the analytic media, against closed forms of their voxels, and against the clouds that
// they were made from.
#include <fstream>
#include <random>

#include "core/error.h"
#include "fixture.h"
#include "render/density_export.h"
#include "tests/height_maps.h"

namespace cloudscape::render {
namespace {

constexpr glm::dvec3 low_m{-150, 900, 950}, size_m{300, 200, 100};  // of most of the grids here

class Grids : public OwnStackTest {
 protected:
  Grids() : stack_(gpu::PassExecution::automatic, {}, folder_.path()) {}
  void write(const std::string& name, const std::vector<float>& densities) const {
    std::ofstream(folder_.path() / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(densities.data()),
               static_cast<std::streamsize>(densities.size() * sizeof(float)));
  }
  // The file "a.raw" of these densities, as a grid in the box.
  Cloudscape grid(const std::array<int, 3>& size, const std::vector<float>& densities, double extinction_per_m = 0.01) {
    write("a.raw", densities);
    Cloudscape sky = homogeneous(VolumeKind::grid, low_m, size_m, extinction_per_m);
    sky.volume.grid.file = "a.raw";
    sky.volume.grid.size = size;
    sky.wind.speed_m_per_s = 0;
    return sky;
  }
  Frame render(const FrameRequest& request) {
    Frame frame = stack_.renderer.render(request);
    stack_.renderer.forget(request.stream);
    return frame;
  }
  // A ray at a point of the box's middle slice, from the south.
  static CameraPose from_south(double east_m, double altitude_m) { return {{east_m, 0, altitude_m}, 0, 0, 0}; }
  // Its optical depth, by small steps.
  double optical_depth(const Cloudscape& sky, const CameraPose& pose) {
    FrameRequest request = one_ray(sky, pose);
    request.march.step_m = 0.5;
    request.march.max_steps = 16384;
    return -std::log(1 - opacity(render(request)));
  }
  HeightMapFolder folder_;
  Stack stack_;
};

void expect_alike(const Frame& a, const Frame& b, double share, const std::string& what) {
  EXPECT_NEAR(red(a) / red(b), 1, share) << what;
  EXPECT_NEAR(opacity(a), opacity(b), share) << what;
}

TEST_F(Grids, OfOneDensityIsAHomogeneousBox) {
  for (const LightModelKind light : {LightModelKind::single, LightModelKind::olajos, LightModelKind::beer_octaves}) {
    Cloudscape voxels = grid({5, 4, 3}, std::vector<float>(60, 0.25F), 0.005);
    voxels.volume.grid.density_scale = 8;  // a density of 2
    Cloudscape box = homogeneous(VolumeKind::box, low_m, size_m, 0.01);
    for (Cloudscape* sky : {&voxels, &box}) {
      sky->medium.light_model.kind = light;
      sky->medium.phase.asymmetry_g = 0.5;
      sky->sun.azimuth_deg = 100, sky->sun.elevation_deg = 35;
    }
    for (const CameraPose& pose : {CameraPose{{20, 0, 1010}, 0, 0, 0}, CameraPose{{-400, 700, 700}, 55, 24, 0}}) {
      FrameRequest as_grid = one_beam(voxels, pose), as_box = one_beam(box, pose);
      for (FrameRequest* request : {&as_grid, &as_box}) request->march.light_steps = 64;
      as_grid.march.step_m = 1;
      expect_alike(render(as_grid), render(as_box), 0.01, std::string(name_of(light)));
    }
  }
}

// Each layer of voxels, looked through from the south: no other density has a part in it, nor has another axis.
TEST_F(Grids, NeedNotBeCubes) {
  std::vector<float> densities;
  for (int z = 0; z < 5; ++z)
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 7; ++x) densities.push_back(static_cast<float>(1 + x + 10 * z) * (y == 0 ? 0.75F : 0.25F));
  Cloudscape sky = grid({7, 2, 5}, densities, 1e-4);
  sky.volume.grid.interpolation = VoxelInterpolation::nearest;
  for (const int x : {0, 2, 6})
    for (const int z : {0, 3, 4}) {
      const double depth = optical_depth(sky, from_south(low_m.x + (x + 0.5) / 7 * size_m.x, low_m.z + 20 * z + 10));
      EXPECT_NEAR(depth / (1e-4 * (1 + x + 10 * z) * 0.5 * size_m.y), 1, 0.01) << x << ", " << z;
    }
}

TEST_F(Grids, AreLinearBetweenTheMiddlesOfVoxelsOrHaveHardFaces) {
  Cloudscape sky = grid({2, 1, 1}, {0.2F, 1});
  const auto depth_at = [&](double share) { return optical_depth(sky, from_south(low_m.x + share * size_m.x, 1000)); };
  const double whole = 0.01 * size_m.y;
  for (const double share : {0.01, 0.2, 0.3, 0.5, 0.7, 0.8, 0.99}) {
    const double expected = whole * (0.2 + 0.8 * std::clamp((share - 0.25) / 0.5, 0.0, 1.0));
    EXPECT_NEAR(depth_at(share) / expected, 1, 0.015) << share;
  }
  sky.volume.grid.interpolation = VoxelInterpolation::nearest;
  for (const double share : {0.01, 0.3, 0.49, 0.51, 0.7, 0.99})
    EXPECT_NEAR(depth_at(share) / (whole * (share < 0.5 ? 0.2 : 1)), 1, 0.01) << share;
}

TEST_F(Grids, StandAloneOrRepeat) {
  Cloudscape sky = grid({2, 1, 1}, {0.2F, 1});
  sky.volume.grid.interpolation = VoxelInterpolation::nearest;
  EXPECT_EQ(opacity(render(one_ray(sky, from_south(low_m.x + 1.25 * size_m.x, 1000)))), 0) << "beside";
  EXPECT_EQ(opacity(render(one_ray(sky, from_south(0, low_m.z + size_m.z + 1)))), 0) << "above";
  sky.volume.grid.tiling = true;
  sky.medium.extinction_per_m = 0.001;
  // Straight down through the layer, several periods away in both directions.
  for (const double period : {0.0, 1.0, -3.0, 40.0})
    for (const double share : {0.25, 0.75}) {
      const glm::dvec3 camera(low_m.x + (period + share) * size_m.x, low_m.y + (0.3 - period) * size_m.y, 3000);
      const double depth = optical_depth(sky, {camera, 0, -90, 0});
      EXPECT_NEAR(depth / (0.001 * size_m.z * (share < 0.5 ? 0.2 : 1)), 1, 0.01) << period << ", " << share;
    }
}

TEST_F(Grids, AreFlatHoweverFarAway) {
  Cloudscape sky = grid({4, 4, 4}, std::vector<float>(64, 1));
  sky.volume.origin_m.y = 100000;
  EXPECT_GT(opacity(render(one_ray(sky, from_south(0, 1000)))), 0.8) << "785 m below the horizontal of a round planet";
  EXPECT_EQ(opacity(render(one_ray(sky, from_south(0, 1060)))), 0);
}

TEST_F(Grids, DriftWithTheWind) {
  Cloudscape sky = grid({1, 1, 1}, {1});
  sky.wind = {10, 90};
  FrameRequest request = one_ray(sky, from_south(0, 1000));
  EXPECT_GT(opacity(render(request)), 0.5);
  request.time_s = 16;  // 160 m: half of it is 150 m
  EXPECT_EQ(opacity(render(request)), 0);
  request.pose.position_m.x += 160;
  EXPECT_GT(opacity(render(request)), 0.5);
}

// Single voxels in much air: with large steps through the air nothing of them may be missing.
TEST_F(Grids, NothingIsMissedInClearAir) {
  std::mt19937 random(5);
  std::vector<float> densities(40 * 24 * 12, 0.0F);
  for (int i = 0; i < 300; ++i)
    densities[random() % densities.size()] = 0.05F + static_cast<float>(random() % 100) / 100;
  for (const bool tiling : {false, true})
    for (const VoxelInterpolation interpolation : {VoxelInterpolation::linear, VoxelInterpolation::nearest}) {
      Cloudscape sky = grid({40, 24, 12}, densities, 0.2);
      sky.volume.grid.tiling = tiling, sky.volume.grid.interpolation = interpolation;
      for (const CameraPose& pose : {CameraPose{{-40, 400, 900}, 8, 9, 0}, CameraPose{{0, 1000, 1600}, 40, -70, 0}}) {
        FrameRequest with = picture(sky, pose, {48, 27});
        with.march.step_m = 1, with.march.max_steps = 8000, with.march.max_distance_m = 3000;
        FrameRequest by_structure = with;
        by_structure.march.distance_field = false;
        FrameRequest without = by_structure;
        without.march.structure = false;
        const Frame b = render(without);
        for (const Frame& a : {render(with), render(by_structure)}) {
          double cloud = 0, difference = 0;
          for (int i = 0; i < 48 * 27; ++i) {
            cloud += opacity(b, i);
            difference += std::abs(opacity(a, i) - opacity(b, i));
            EXPECT_NEAR(opacity(a, i), opacity(b, i), 0.05) << i << (tiling ? ", tiling" : "");
          }
          EXPECT_GT(cloud / (48 * 27), 0.01) << "nothing to miss";
          EXPECT_LT(difference / cloud, 0.01);
        }
      }
    }
}

TEST_F(Grids, AreReadAgainWhenTheirFileChanges) {
  const Cloudscape sky = grid({1, 1, 1}, {1});
  const auto depth = [&] { return optical_depth(sky, from_south(0, 1000)); };
  EXPECT_NEAR(depth(), 0.01 * size_m.y, 0.02);
  write("a.raw", {0.5F});
  EXPECT_NEAR(depth(), 0.005 * size_m.y, 0.02);
}

TEST_F(Grids, ThatCannotBeUsedAreTold) {
  Cloudscape sky = grid({1, 1, 1}, {1});
  sky.volume.grid.file = "b.raw";
  for (int i = 0; i < 2; ++i) EXPECT_THROW(render(one_ray(sky, from_south(0, 1000))), UnusableFile);
  write("b.raw", {1});
  EXPECT_GT(opacity(render(one_ray(sky, from_south(0, 1000)))), 0.5) << "once it is there";
}

double mean_radiance(const Frame& frame) {
  double sum = 0;
  for (std::size_t i = 0; i < frame.depth_m.size(); ++i) sum += red(frame, static_cast<int>(i));
  return sum / static_cast<double>(frame.depth_m.size());
}

// Sum over the pixels, as a share of the first frame's.
double opacity_difference(const Frame& a, const Frame& b) {
  double difference = 0, cloud = 0;
  for (std::size_t i = 0; i < a.depth_m.size(); ++i) {
    difference += std::abs(opacity(a, static_cast<int>(i)) - opacity(b, static_cast<int>(i)));
    cloud += opacity(a, static_cast<int>(i));
  }
  EXPECT_GT(cloud, 0.05 * static_cast<double>(a.depth_m.size())) << "nothing to see";
  return difference / cloud;
}

// Noise clouds, written voxel by voxel and marched as a grid. Their light is not compared closely: noise is lit through
// a coarser shape than it shows (shaders/render/cloud_light.glsl), which voxels are not.
TEST_F(Grids, MadeOfNoiseCloudsAreTheseClouds) {
  Cloudscape clouds = small_clouds();
  clouds.volume.tiling = false;
  clouds.volume.size_m = {1600, 1600, 512};
  clouds.shape.coverage = 0.5;
  clouds.medium.extinction_per_m = 0.02;
  clouds.wind.speed_m_per_s = 0;
  clouds.ground.kind = GroundKind::none;
  const auto baked = stack_.bakes.get(stack_.bakes.recipe_of(clouds));
  DensityExport density(stack_.shaders, clouds, *baked, 200);
  EXPECT_EQ(density.size(), glm::ivec3(200, 200, 64));
  std::vector<float> voxels;
  for (int z = 0; z < density.size().z; z += DensityExport::slab)
    for (const float value : density.slices(z)) voxels.push_back(value);
  write("clouds.raw", voxels);
  Cloudscape copy = clouds;
  copy.volume.kind = VolumeKind::grid;
  copy.volume.grid.file = "clouds.raw";
  copy.volume.grid.size = {200, 200, 64};
  const auto seen = [&](const Cloudscape& sky, const CameraPose& pose) {
    FrameRequest request = picture(sky, pose, {48, 27});
    request.march.step_m = 4, request.march.max_steps = 2000;
    return render(request);
  };
  Cloudscape beside = copy;
  beside.volume.origin_m += glm::dvec3(8);  // by one voxel
  for (const CameraPose& pose : {CameraPose{{800, -900, 400}, 0, 38, 0}, CameraPose{{600, 100, 2600}, 30, -60, 0}}) {
    const Frame own = seen(clouds, pose), grid = seen(copy, pose);
    // Voxels of 8 m smooth the edges, and the steps of the eight bits there, each a fifth of the density.
    const double difference = opacity_difference(own, grid);
    EXPECT_LT(difference, 0.06);
    EXPECT_GT(opacity_difference(own, seen(beside, pose)), 1.5 * difference);
    EXPECT_NEAR(mean_radiance(grid) / mean_radiance(own), 1, 0.1);
  }
}

TEST_F(Grids, MadeOfAnalyticMediaHaveTheirMass) {
  const Cloudscape sphere = ball(100, 1);
  const auto baked = stack_.bakes.get(stack_.bakes.recipe_of(sphere));
  DensityExport density(stack_.shaders, sphere, *baked, 50);
  double sum = 0;
  for (int z = 0; z < density.size().z; z += DensityExport::slab)
    for (const float value : density.slices(z)) sum += value;
  const double volume_m3 = sum * std::pow(density.voxel_m(), 3);
  EXPECT_NEAR(volume_m3 / (4.0 / 3 * std::numbers::pi * 1e6), 1, 0.005);
  EXPECT_EQ(density.extinction_per_m(), 0.01);
  EXPECT_EQ(density.low_m(), ball_center_m - 100.0);
}

}  // namespace
}  // namespace cloudscape::render
