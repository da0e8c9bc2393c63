// What the random numbers of a path-traced picture depend on, and when it ends.
#include <chrono>

#include "traced.h"

namespace cloudscape::render {
namespace {

using TracedAgain = TraceTest;

FrameRequest small_picture(std::uint32_t seed, int samples = 8) {
  Cloudscape sky = small_clouds();
  sky.medium.phase = {PhaseKind::two_lobe, 0.8, -0.3, 0.2};
  FrameRequest request = traced_picture(sky, {{0, 0, 300}, 30, 25, 0}, {32, 20}, samples);
  request.tracing.seed = seed;
  return request;
}

TEST_F(TracedAgain, TheSameSeedGivesTheSameBytesInSlicesOfAnySize) {
  const Frame whole = traced(small_picture(7));
  for (const int paths : {200, 1 << 30}) {
    renderer().tracer().limit_slices(paths);
    const Frame sliced = traced(small_picture(7));
    EXPECT_EQ(sliced.radiance_rgba, whole.radiance_rgba) << paths;
    EXPECT_EQ(sliced.depth_m, whole.depth_m);
    EXPECT_EQ(sliced.standard_error_rgb, whole.standard_error_rgb);
  }
}

// Another picture may be rendered between any two slices.
TEST_F(TracedAgain, FramesInBetweenChangeNothing) {
  const Frame alone = traced(small_picture(7));
  const FrameRequest request = small_picture(7);
  auto job = renderer().begin(request);
  renderer().tracer().limit_slices(400);
  while (!renderer().advance(*job)) traced(picture(ball(100, 1), {camera_m, 0, 0, 0}, {8, 8}));
  renderer().tracer().limit_slices(1 << 30);
  const Frame between = renderer().collect(renderer().finish(std::move(job)));
  renderer().forget(request.stream);
  EXPECT_EQ(between.radiance_rgba, alone.radiance_rgba);
}

// Welch's test (1947) of the two means of each pixel: the statistic has a variance of 1 where errors are what they
// claim to be and the pictures are independent.
TEST_F(TracedAgain, AnotherSeedGivesAnIndependentPictureOfTheSame) {
  const Frame a = traced(small_picture(1, 64)), b = traced(small_picture(2, 64));
  double sum = 0, squares = 0, values = 0;
  for (std::size_t pixel = 0; pixel < a.depth_m.size(); ++pixel) {
    const double error = std::hypot(a.standard_error_rgb[3 * pixel], b.standard_error_rgb[3 * pixel]);
    if (error <= 1e-6) continue;  // nothing but sky
    const double t = (a.radiance_rgba[4 * pixel] - b.radiance_rgba[4 * pixel]) / error;
    sum += t, squares += t * t, ++values;
  }
  ASSERT_GT(values, 400);
  EXPECT_NEAR(sum / values, 0, 4 / std::sqrt(values));
  EXPECT_NEAR(squares / values, 1, 0.25);
}

TEST_F(TracedAgain, EndsAtTheNoiseTarget) {
  FrameRequest request = small_picture(3, 4096);
  request.tracing.noise_target = 0.5;
  const Frame frame = traced(request);
  double sum = 0, squares = 0;
  for (std::size_t pixel = 0; pixel < frame.depth_m.size(); ++pixel)
    for (std::size_t colour = 0; colour < 3; ++colour) {
      sum += frame.radiance_rgba[4 * pixel + colour];
      squares += std::pow(frame.standard_error_rgb[3 * pixel + colour], 2);
    }
  const double values = 3.0 * static_cast<double>(frame.depth_m.size());
  EXPECT_LE(std::sqrt(squares / values) / (sum / values), 0.5);
  EXPECT_GE(frame.samples, 4);
  EXPECT_LT(frame.samples, 4096);
}

TEST_F(TracedAgain, EndsWithinTheTimeBudget) {
  FrameRequest request = small_picture(3, 4096);
  request.tracing.time_budget_s = 0.5;
  auto job = renderer().begin(request);
  while (!renderer().advance(*job)) {
  }
  EXPECT_LT(job->trace->stand.seconds, 1);  // a wave is finished
  EXPECT_EQ(job->trace->counts.samples, static_cast<std::uint64_t>(job->trace->stand.samples) * 32 * 20);
  EXPECT_LT(job->trace->stand.samples, 4096);
  renderer().collect(renderer().finish(std::move(job)));
  renderer().forget(request.stream);
}

TEST_F(TracedAgain, TheBlockIsLaidOutAsInCpp) {
  for (const char* path :
       {"trace/paths.comp", "trace/paths_terrain.comp", "trace/paths_air.comp", "trace/paths_terrain_air.comp"}) {
    const gpu::StoragePass pass(stack().shaders, path);
    EXPECT_EQ(pass.program().block_offsets("TraceBlock"), TraceBlock::offsets());
  }
}

TEST(TracePlan, NeverAsksForMoreThanTheGoal) {
  EXPECT_EQ(next_wave({.samples = 64}, {}), 64);
  EXPECT_EQ(next_wave({.samples = 64}, {.samples = 64}), 0);
  // Half of what the time left allows.
  const TraceGoal budget{.samples = 4096, .time_budget_s = 10};
  EXPECT_EQ(next_wave(budget, {}), 1);
  EXPECT_EQ(next_wave(budget, {.samples = 1, .seconds = 0.1}), 49);
  EXPECT_EQ(next_wave(budget, {.samples = 99, .seconds = 9.91}), 0);
  // Errors fall with the square root of the samples.
  const TraceGoal noise{.samples = 4096, .noise_target = 0.01};
  EXPECT_EQ(next_wave(noise, {.samples = 100, .relative_error = 0.0112}), 26);
  EXPECT_EQ(next_wave(noise, {.samples = 100, .relative_error = 0.1}), 100);
  EXPECT_EQ(next_wave(noise, {.samples = 100, .relative_error = 0.01}), 0);
  EXPECT_EQ(next_wave(noise, {.samples = 4000, .relative_error = 0.1}), 96);
}

}  // namespace
}  // namespace cloudscape::render
