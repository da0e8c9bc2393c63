// Noise layers: where clouds can be, how they drift and repeat, and that no pose breaks a picture.
#include "fixture.h"
#include "settings/cloudscape_json.h"

namespace cloudscape::render {
namespace {

using Layer = RenderTest;

double mean_opacity(const Frame& frame) {
  double sum = 0;
  const std::size_t pixels = frame.depth_m.size();
  for (std::size_t i = 0; i < pixels; ++i) sum += opacity(frame, static_cast<int>(i));
  return sum / static_cast<double>(pixels);
}

double largest_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max<double>(largest, std::abs(a[i] - b[i]));
  return largest;
}

TEST_F(Layer, IsSeenFromBelowInsideAndAbove) {
  const Cloudscape sky = small_clouds();  // between 1000 m and 2600 m
  EXPECT_GT(mean_opacity(render(picture(sky, {{0, 0, 100}, 0, 60, 0}, {12, 8}))), 0.2) << "from below";
  EXPECT_GT(mean_opacity(render(picture(sky, {{0, 0, 1300}, 0, 0, 0}, {12, 8}))), 0.3) << "inside";
  EXPECT_GT(mean_opacity(render(picture(sky, {{0, 0, 6000}, 0, -60, 0}, {12, 8}))), 0.2) << "from above";
}

TEST_F(Layer, IsNowhereElse) {
  Cloudscape sky = small_clouds();
  EXPECT_EQ(mean_opacity(render(picture(sky, {{0, 0, 2601}, 0, 40, 0}, {12, 8}))), 0) << "up from above";
  EXPECT_EQ(mean_opacity(render(picture(sky, {{0, 0, 999}, 0, -40, 0}, {12, 8}))), 0) << "down from below";
  sky.volume.tiling = false;  // 8 km from the origin on
  EXPECT_EQ(mean_opacity(render(picture(sky, {{-5000, 4000, 1500}, 270, 0, 0}, {12, 8}))), 0) << "beside, away from it";
  EXPECT_GT(mean_opacity(render(picture(sky, {{-5000, 4000, 1500}, 90, 0, 0}, {12, 8}))), 0) << "beside, towards it";
}

TEST_F(Layer, DriftsWithTheWind) {
  Cloudscape sky = small_clouds();
  sky.wind = {20, 60, 0, 0};
  sky.ground.kind = GroundKind::none;
  FrameRequest later = picture(sky, {{300, 100, 200}, 10, 40, 0}, {24, 16});
  later.time_s = 90;
  FrameRequest upwind = picture(sky, later.pose, {24, 16});
  upwind.pose.position_m -= glm::dvec3(std::sin(radians(60)), std::cos(radians(60)), 0) * 20.0 * 90.0;
  const Frame a = render(later), b = render(upwind);
  EXPECT_LT(largest_difference(a.radiance_rgba, b.radiance_rgba), 5e-3);
  later.time_s = 0;
  EXPECT_GT(largest_difference(a.radiance_rgba, render(later).radiance_rgba), 0.05) << "it must have moved";
}

TEST_F(Layer, RepeatsWithItsTile) {
  Cloudscape sky = small_clouds();
  sky.ground.kind = GroundKind::none;
  const CameraPose pose{{300, 100, 200}, 10, 40, 0};
  const Frame here = render(picture(sky, pose, {24, 16}));
  const auto shifted = [&](double east_m, double north_m) {
    CameraPose there = pose;
    there.position_m += glm::dvec3(east_m, north_m, 0);
    return largest_difference(here.radiance_rgba, render(picture(sky, there, {24, 16})).radiance_rgba);
  };
  // Five tiles are a whole number of periods of the fine detail, too.
  EXPECT_LT(shifted(8000 * 5, 0), 5e-3);
  EXPECT_LT(shifted(-8000 * 100, 8000 * 15), 5e-3);
  EXPECT_GT(shifted(4000, 0), 0.05);
  sky.shape.coverage_variation.amount = 0.8;
  const Frame varied = render(picture(sky, pose, {24, 16}));
  CameraPose next = pose;
  next.position_m.x += 8000 * 5;
  EXPECT_GT(largest_difference(varied.radiance_rgba, render(picture(sky, next, {24, 16})).radiance_rgba), 0.02)
      << "variation hides the tiling";
}

void expect_sane(const Frame& frame, const std::string& what) {
  for (const float value : frame.radiance_rgba) {
    ASSERT_TRUE(std::isfinite(value)) << what;
    ASSERT_GE(value, 0) << what;
  }
  for (std::size_t pixel = 0; pixel < frame.depth_m.size(); ++pixel) {
    ASSERT_LE(opacity(frame, static_cast<int>(pixel)), 1) << what;
    ASSERT_FALSE(std::isnan(frame.depth_m[pixel])) << what;
    ASSERT_GE(frame.depth_m[pixel], 0) << what;
  }
}

struct HardPose {
  const char* name;
  glm::dvec3 position_m;
  double elevation_deg;
};
constexpr HardPose hard_poses[] = {
    {"on the ground", {0, 0, 0}, 0},        {"straight up", {0, 0, 2}, 90},
    {"straight down", {0, 0, 3000}, -90},   {"inside", {100, 100, 1400}, 5},
    {"far away", {1e6, -1e6, 500}, 10},     {"very far away", {1e7, 1e7, 500}, 10},
    {"in space", {0, 0, 100000}, -20},      {"farther in space", {0, 0, 1e6}, -45},
    {"below the ground", {0, 0, -100}, 10}, {"below, looking down", {0, 0, -100}, -30},
};

class EveryPreset : public RenderTest, public testing::WithParamInterface<std::string> {
 protected:
  static Cloudscape small_preset() {
    Cloudscape sky = *settings::CloudscapeLibrary({}).get(GetParam());
    sky.volume.resolution = 16;  // the bake is not what is tested
    sky.detail.resolution = 16;
    sky.medium.light_model.volume_resolution = 16;
    return sky;
  }
};

TEST_P(EveryPreset, IsFiniteAndNotNegativeFromEverywhere) {
  const Cloudscape sky = small_preset();
  for (const HardPose& pose : hard_poses)
    expect_sane(render(picture(sky, {pose.position_m, 30, pose.elevation_deg, 0}, {8, 8})), pose.name);
  for (const double bound_m : {sky.volume.origin_m.z, sky.volume.origin_m.z + sky.volume.size_m.z})
    for (const double elevation_deg : {-90.0, -10.0, 0.0, 10.0, 90.0})
      expect_sane(render(picture(sky, {{0, 0, bound_m}, 30, elevation_deg, 0}, {4, 4})), "at a bound of the layer");
}

TEST_P(EveryPreset, IsFiniteAndNotNegativeUnderEverySun) {
  Cloudscape sky = small_preset();
  for (const double elevation_deg : {-90.0, -20.0, -3.0, -0.5, 0.0, 0.5, 89.9, 90.0}) {
    sky.sun.elevation_deg = elevation_deg;
    const CameraPose at_sun{sky.view.pose.position_m, sky.sun.azimuth_deg, elevation_deg, 0};
    for (const CameraPose& pose : {sky.view.pose, at_sun})
      expect_sane(render(picture(sky, pose, {8, 8})), "sun at " + std::to_string(elevation_deg));
  }
}

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const auto& entry : settings::CloudscapeLibrary({}).list()) names.push_back(entry.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Presets, EveryPreset, testing::ValuesIn(preset_names()), [](const auto& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace cloudscape::render
