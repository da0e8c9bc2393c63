// The path tracer in noise clouds, against the march with steps so small that it has no error of its own.
#include "gpu/render/layered_clouds.h"
#include "traced.h"

namespace cloudscape::render {
namespace {

using TracedNoise = TraceTest;

// Densities that change slowly, so that few light steps are exact: no detail, and soft edges.
Cloudscape soft_clouds() {
  Cloudscape sky = small_clouds();
  sky.shape.edge_softness = 0.5;
  sky.detail.strength = 0;
  sky.detail.period_m = 10;
  sky.medium.extinction_per_m = 0.01;
  sky.medium.ambient = 0;
  sky.medium.light_model.kind = LightModelKind::single;
  sky.medium.phase = {PhaseKind::henyey_greenstein, 0.3};
  sky.sky.kind = SkyKind::none;
  sky.ground.kind = GroundKind::none;
  sky.sun.irradiance = glm::dvec3(1);
  sky.sun.disc = false;
  return sky;
}

// The same of two layers, the upper one thinner.
Cloudscape soft_layers() {
  Cloudscape sky = soft_clouds();
  const Cloudscape layered = layered_clouds();
  sky.volume.resolution = layered.volume.resolution;
  sky.shape.top_m = layered.shape.top_m;
  sky.layers = layered.layers;
  sky.layers[0].coverage = 0.9, sky.shape.coverage = 0.6;
  sky.medium.extinction_per_m = 0.04;
  return sky;
}

// The small steps add up to the view's whole way through the layer.
FrameRequest marched(const FrameRequest& traced) {
  FrameRequest request = traced;
  request.stream = next_stream();
  request.quality = {
      .max_steps = 4000, .step_m = 2, .step_growth = 0, .light_steps = 14, .samples = 16, .float32 = true};
  return request;
}

double mean_of(const Frame& frame, std::size_t channel) {
  double sum = 0;
  for (std::size_t i = channel; i < frame.radiance_rgba.size(); i += 4) sum += frame.radiance_rgba[i];
  return 4 * sum / static_cast<double>(frame.radiance_rgba.size());
}

// Of 10 degrees, so that no ray is longer than so many small steps.
FrameRequest narrow(const Cloudscape& sky, const CameraPose& pose, int samples) {
  FrameRequest request = traced_picture(sky, pose, {24, 16}, samples);
  request.lens.vertical_fov_deg = 10;
  request.tracing.max_scattering_order = 1;
  return request;
}

// Views from below, through the layer at a slant, and from within it.
const CameraPose poses[] = {{{0, 0, 100}, 20, 70, 0}, {{0, 0, 100}, 200, 20, 0}, {{300, 200, 2600}, 200, -60, 0}};

TEST_F(TracedNoise, LetsThroughWhatTheMarchLetsThrough) {
  for (const bool detailed : {false, true})
    for (const CameraPose& pose : poses) {
      Cloudscape sky = soft_clouds();
      if (detailed) sky.detail = small_clouds().detail, sky.shape.edge_softness = 0.1;
      const FrameRequest request = narrow(sky, pose, 128);
      const double traced_share = mean_of(traced(request), 3), marched_share = mean_of(traced(marched(request)), 3);
      EXPECT_NEAR(traced_share, marched_share, 0.01);
    }
}

TEST_F(TracedNoise, LetsThroughSeveralLayersWhatTheMarchDoes) {
  for (const CameraPose& pose : poses) {
    const FrameRequest request = narrow(soft_layers(), pose, 128);
    const double traced_share = mean_of(traced(request), 3);
    EXPECT_NEAR(traced_share, mean_of(traced(marched(request)), 3), 0.01);
    EXPECT_GT(traced_share, 0.05);
  }
}

TEST_F(TracedNoise, ScattersOnceAsTheMarchDoes) {
  for (const Cloudscape& sky : {soft_clouds(), soft_layers()})
    for (const CameraPose& pose : poses) {
      const FrameRequest request = narrow(sky, pose, 256);
      const Measured once = measured(traced(request));
      const double expected = mean_of(traced(marched(request)), 0);
      EXPECT_NEAR(once.over(expected), 1, 0.01 + 3 * once.error / expected);
    }
}

// Clouds that do not absorb, in a sky that is the same all round, cannot be seen; and no density exceeds its bound on
// the way, whether they lean or not.
class TracedFurnace : public TraceTest,
                      public testing::WithParamInterface<std::pair<bool, bool>> {};  // tiling, layered

TEST_P(TracedFurnace, IsWhite) {
  const auto [tiling, layered] = GetParam();
  for (const double variation : {0.0, 0.8}) {
    Cloudscape sky = layered ? layered_clouds() : small_clouds();
    sky.volume.tiling = tiling;
    sky.wind.shear_per_s = variation > 0 ? 0.02 : 0;
    sky.shape.coverage_variation = {variation, 20000};
    sky.sky = {SkyKind::uniform, glm::dvec3(0.5)};
    sky.ground.kind = GroundKind::none;
    sky.sun.irradiance = glm::dvec3(0);
    const FrameRequest request = traced_picture(sky, {{2000, 2000, 500}, 45, 15, 0}, {32, 16}, 16);
    auto job = renderer().begin(request);
    while (!renderer().advance(*job)) {
    }
    EXPECT_EQ(job->trace->counts.above_majorant, 0U);
    EXPECT_EQ(job->trace->counts.samples, 32U * 16 * 16);
    const Frame frame = renderer().collect(renderer().finish(std::move(job)));
    renderer().forget(request.stream);
    EXPECT_GT(mean_of(frame, 3), 0.05);
    for (int pixel = 0; pixel < 32 * 16; ++pixel) ASSERT_NEAR(red(frame, pixel), 0.5, 1e-5);
  }
}

INSTANTIATE_TEST_SUITE_P(Clouds, TracedFurnace,
                         testing::Values(std::pair(true, false), std::pair(false, false), std::pair(true, true)));

}  // namespace
}  // namespace cloudscape::render
