// What the wind does to clouds: they drift, lean and change, none is missed on the way, and nothing jumps.
#include "core/wind.h"
#include "core/sun_position.h"
#include "fixture.h"
#include "render/density_export.h"

namespace cloudscape::render {
namespace {

using Windy = RenderTest;

Cloudscape leaning(double shear_per_s, double variation = 0) {
  Cloudscape sky = small_clouds();
  sky.volume.resolution = 64;
  sky.shape.coverage = 0.2;
  sky.shape.coverage_variation = {variation, 20000};
  sky.ground.kind = GroundKind::none;
  sky.wind = {10, 60, shear_per_s, 0};
  return sky;
}

double mean_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
  return sum / static_cast<double>(a.size());
}

std::vector<float> densities(Stack& stack, const Cloudscape& sky, int resolution) {
  const auto baked = stack.bakes.get(stack.bakes.recipe_of(sky));
  DensityExport density(stack.shaders, sky, *baked, resolution);
  std::vector<float> voxels;
  for (int z = 0; z < density.size().z; z += DensityExport::slab)
    for (const float value : density.slices(z)) voxels.push_back(value);
  return voxels;
}

// Each slice of the layer is that of the upright one, moved by its height's share of the lean.
TEST_F(Windy, LeansByItsHeightsShare) {
  constexpr int side = 128, layers = 32;
  Cloudscape sky = leaning(0.0015);
  sky.wind.towards_azimuth_deg = 90;  // so that only one axis is to be interpolated
  Cloudscape upright = sky;
  upright.wind.shear_per_s = 0;
  const std::vector<float> leant = densities(stack(), sky, side), straight = densities(stack(), upright, side);
  ASSERT_EQ(leant.size(), std::size_t{side} * side * layers);
  const double voxel_m = sky.volume.size_m.x / side;
  std::vector<float> expected(leant.size());
  for (int z = 0; z < layers; ++z) {
    const double shift = lean_m(sky).x * (z + 0.5) / layers / voxel_m, whole = std::floor(shift);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const auto at = [&](int from) {
          return straight[static_cast<std::size_t>((z * side + y) * side + ((from % side) + side) % side)];
        };
        const int from = x - static_cast<int>(whole);
        expected[static_cast<std::size_t>((z * side + y) * side + x)] =
            std::lerp(at(from), at(from - 1), static_cast<float>(shift - whole));
      }
  }
  const double moved = mean_difference(leant, straight), off = mean_difference(leant, expected);
  EXPECT_GT(moved, 0.003) << "it must lean";
  EXPECT_LT(off, 0.2 * moved) << "interpolation smooths the edges";
}

// As technique_test has it: small steps lie at the same places, so that only a cloud that was missed can differ.
TEST_F(Windy, NoCloudThatLeansIsMissed) {
  const CameraPose below{{500, 200, 60}, 30, 25, 0}, above{{0, 0, 5000}, 60, -20, 0},
      inside{{900, 700, 1450}, 100, 3, 0}, against{{500, 200, 60}, 240, 25, 0}, grazing{{0, 0, 2590}, 200, -0.5, 0};
  for (const double shear : {0.02, -0.02})
    for (const double variation : {0.0, 0.6})
      for (const CameraPose& pose : {below, above, inside, against, grazing}) {
        FrameRequest request = picture(leaning(shear, variation), pose, {48, 27});
        request.march.step_m = 10, request.march.max_steps = 16384, request.march.max_distance_m = 30000;
        request.time_s = 333;
        const Frame by_distances = render(request);
        request.march.distance_field = false;
        const Frame by_structure = render(request);
        request.march.structure = false;
        const Frame without = render(request);
        for (const Frame& with : {by_distances, by_structure}) {
          double cloud = 0;
          for (int i = 0; i < 48 * 27; ++i) {
            EXPECT_LT(std::abs(opacity(with, i) - opacity(without, i)), 0.02)
                << "altitude " << pose.position_m.z << ", shear " << shear << ", pixel " << i;
            cloud += opacity(without, i);
          }
          EXPECT_LT(mean_difference(with.radiance_rgba, without.radiance_rgba), 1e-3);
          EXPECT_GT(cloud / (48 * 27), 0.02) << "nothing to miss";
        }
      }
}

// In time all moves as the wind at the layer's bottom, lean and variation included, where nothing evolves.
TEST_F(Windy, AfterATimeAllIsWhereTheWindHasBlownIt) {
  const Cloudscape sky = leaning(0.002, 0.6);
  FrameRequest later = picture(sky, {{300, 100, 200}, 10, 40, 0}, {24, 16});
  later.time_s = 4000;
  FrameRequest upwind = later;
  upwind.time_s = 0;
  upwind.pose.position_m -= glm::dvec3(drift_m_per_s(sky) * later.time_s, 0);
  EXPECT_NEAR(glm::length(drift_m_per_s(sky)), 10 + 0.002 * 1000, 1e-9);
  const Frame a = render(later), b = render(upwind);
  EXPECT_LT(mean_difference(a.radiance_rgba, b.radiance_rgba), 1e-4);
  upwind.pose = later.pose;
  EXPECT_GT(mean_difference(a.radiance_rgba, render(upwind).radiance_rgba), 0.01) << "it must have moved";
}

class Changing : public RenderTest {
 protected:
  static double change(double evolution_m_per_s, double from_s, double to_s) {
    return mean_difference(render(evolving(evolution_m_per_s, from_s)).radiance_rgba,
                           render(evolving(evolution_m_per_s, to_s)).radiance_rgba);
  }

 private:
  static FrameRequest evolving(double evolution_m_per_s, double time_s);
};

FrameRequest Changing::evolving(double evolution_m_per_s, double time_s) {
  Cloudscape sky = leaning(0.001, 0.4);
  sky.shape.coverage = 0.5;
  sky.detail.strength = 0.4;
  sky.wind.speed_m_per_s = 0, sky.wind.shear_per_s = 0, sky.wind.evolution_m_per_s = evolution_m_per_s;
  FrameRequest request = picture(sky, {{500, 200, 600}, 30, 15, 0}, {48, 27});
  request.quality.step_m = 10, request.quality.step_growth = 0.001, request.quality.max_steps = 2000;
  request.time_s = time_s;
  return request;
}

// Offsets of detail (period 500 m) and of its finer copy wrap at whole periods: no picture may show it.
TEST_F(Changing, DetailChangesSlowlyAndNeverJumps) {
  const double speed = 0.5, period_s = 500 / speed, fine_period_s = 500 / 4.7 / (1.7 * speed);
  EXPECT_EQ(change(0, 0, 5000), 0);
  const double minute = change(speed, 0, 60);
  EXPECT_GT(minute, 1e-3) << "it must change";
  for (const double wrap_s : {period_s, period_s / 0.4, fine_period_s, fine_period_s / 0.4, 7 * fine_period_s})
    EXPECT_LT(change(speed, wrap_s - 0.05, wrap_s + 0.05), 0.05 * minute) << wrap_s;
}

// A clock that has run is a later hour: the picture is that of a document which says so.
TEST_F(Windy, TheSunGoesItsWayWithTheClock) {
  Cloudscape morning = clear_world(0), later;
  morning.sun.place = {47.6, 9.4, "2026-06-21T04:00:00Z", 60};
  later = morning;
  later.sun.place = {47.6, 9.4, "2026-06-21T06:30:00Z", 0};
  for (Cloudscape* sky : {&morning, &later}) place_sun_and_moon(*sky);
  const CameraPose eastwards{{0, 0, 100}, 80, 20, 0};
  FrameRequest running = picture(morning, eastwards, {16, 9});
  const Frame early = render(running);
  running.time_s = 150;
  const Frame late = render(running);
  EXPECT_LT(mean_difference(late.radiance_rgba, render(picture(later, eastwards, {16, 9})).radiance_rgba), 1e-6);
  EXPECT_GT(mean_difference(late.radiance_rgba, early.radiance_rgba), 1e-3);
  EXPECT_EQ(late.request.cloudscape->sun, at_time(running.cloudscape, 150)->sun) << "which a picture's metadata tell";
}

}  // namespace
}  // namespace cloudscape::render
