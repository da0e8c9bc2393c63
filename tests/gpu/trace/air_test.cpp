// The path tracer through the air: against an independent Monte Carlo tracer, a closed form, and itself.
#include "air_cases.h"

namespace cloudscape::render {
namespace {

using TracedAtmosphereTest = TraceTest;

TEST_F(TracedAtmosphereTest, MeetsTheMonteCarloTracer) {
  for (const double sun_deg : {60.0, 10.0, 2.0})
    for (const Look& look : looks) {
      const Colours ours = seen(clear_world(sun_deg, 0.3), look, 32, 16);
      const TracedRadiance truth = by_photons(sun_deg, 0.3, look, 3000);
      for (int i = 0; i < 3; ++i) {
        const double error = std::hypot(ours.error[i] / ours.mean[i], truth.error[i] / truth.mean[i]);
        EXPECT_NEAR(ours.mean[i] / truth.mean[i], 1, 0.01 + 4 * error) << name_of(sun_deg, look) << ", colour " << i;
        EXPECT_LT(error, 0.06);
      }
    }
}

// What the air adds before something black, which here is cloud.
TEST_F(TracedAtmosphereTest, LiesBeforeACloudAsTheMonteCarloTracerSays) {
  for (const double sun_deg : {30.0, 3.0})
    for (const double distance_m : {3000.0, 30000.0}) {
      const Look look{1000, 90, 2};
      const glm::dvec3 direction = direction_of(look.azimuth_deg, look.elevation_deg);
      Cloudscape sky = clear_world(sun_deg, 0);
      sky.volume.size_m = glm::dvec3(400);
      sky.volume.origin_m = glm::dvec3(0, 0, 1000) + direction * (distance_m + 200) - 200.0;
      sky.medium.extinction_per_m = 10, sky.medium.single_scattering_albedo = 0;
      const Colours ours = seen(sky, look, 32, 16);
      const TracedRadiance truth = traced_sky({.sun = direction_of(0, sun_deg)}, 1000, direction, 3000, distance_m);
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(ours.mean[i] / truth.mean[i], 1,
                    0.01 + 4 * std::hypot(ours.error[i] / ours.mean[i], truth.error[i] / truth.mean[i]))
            << distance_m << ", sun " << sun_deg << ", colour " << i;
    }
}

TEST_F(TracedAtmosphereTest, LetsThroughTheSunsDiscAndTheMoonsLight) {
  Cloudscape sky = clear_world(10, 0);
  sky.sun.disc = true;
  const Look at_sun{2, 0, 10}, up{2, 90, 60};
  const Colours disc = seen(sky, at_sun, 16, 64);
  const glm::dvec3 tables = by_tables(sky, at_sun);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(disc.mean[i] / tables[i], 1, 0.01 + 4 * disc.error[i] / tables[i]);
  // So late in twilight that a bright moon is as much as the sun: both light the air.
  Cloudscape twilight = clear_world(-6, 0.1);
  twilight.sky.stars = 0;
  twilight.moon.elevation_deg = 50, twilight.moon.azimuth_deg = 200, twilight.moon.brightness = 1000;
  const glm::dvec3 expected = by_tables(twilight, up);
  const Colours both = seen(twilight, up, 32, 16);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(both.mean[i] / expected[i], 1, 0.1 + 4 * both.error[i] / expected[i]) << i;
}

// A picture through clouds and air.
FrameRequest small_picture(const Cloudscape& sky, std::uint32_t seed, int samples) {
  FrameRequest request = through_air(traced_picture(sky, {{0, 0, 300}, 30, 15, 0}, {32, 20}, samples));
  request.tracing.seed = seed;
  return request;
}

// Mean square of Welch's statistic (1947) over the pixels and colours of two pictures: 1 where they differ by noise
// alone; and the same of the means of the whole pictures.
struct Welch {
  double pixels = 0, whole = 0;
};
Welch compared(const Frame& a, const Frame& b) {
  Welch welch;
  double values = 0;
  for (std::size_t i = 0; i < a.standard_error_rgb.size(); ++i) {
    const std::size_t at = 4 * (i / 3) + i % 3;
    const double error = std::hypot(a.standard_error_rgb[i], b.standard_error_rgb[i]);
    if (error <= 0) continue;
    welch.pixels += std::pow((a.radiance_rgba[at] - b.radiance_rgba[at]) / error, 2), ++values;
  }
  welch.pixels /= values;
  for (std::size_t colour = 0; colour < 3; ++colour) {
    const Measured first = measured(a, colour), second = measured(b, colour);
    welch.whole = std::max(welch.whole, std::abs(first.mean - second.mean) / std::hypot(first.error, second.error));
  }
  return welch;
}

TEST_F(TracedAtmosphereTest, TheSameSeedGivesTheSameBytesInSlicesOfAnySize) {
  const Frame whole = traced(small_picture(small_clouds(), 7, 4));
  renderer().tracer().limit_slices(200);
  const Frame sliced = traced(small_picture(small_clouds(), 7, 4));
  renderer().tracer().limit_slices(1 << 30);
  EXPECT_EQ(sliced.radiance_rgba, whole.radiance_rgba);
  EXPECT_EQ(sliced.standard_error_rgb, whole.standard_error_rgb);
}

TEST_F(TracedAtmosphereTest, AnotherSeedGivesAnIndependentPictureOfTheSame) {
  const Welch welch =
      compared(traced(small_picture(small_clouds(), 1, 64)), traced(small_picture(small_clouds(), 2, 64)));
  EXPECT_NEAR(welch.pixels, 1, 0.15);
  EXPECT_LT(welch.whole, 4);
}

// Without air both ways of tracing it mean the same, whatever clouds there are, from below, within and above.
TEST_F(TracedAtmosphereTest, WithoutAirIsAsByTables) {
  Cloudscape sky = small_clouds();
  sky.sky.rayleigh = 0, sky.sky.haze = 0, sky.sky.ozone = 0;
  for (const CameraPose& pose :
       {CameraPose{{0, 0, 300}, 30, 15, 0}, CameraPose{{0, 0, 2000}, 30, 0, 0}, CameraPose{{0, 0, 9000}, 30, -30, 0}}) {
    const FrameRequest request = traced_picture(sky, pose, {32, 20}, 64);
    const Welch welch = compared(traced(request), traced(through_air(request)));
    EXPECT_NEAR(welch.pixels, 1, 0.2) << pose.position_m.z;
    EXPECT_LT(welch.whole, 4) << pose.position_m.z;
  }
}

// Clouds along the horizon 800 km away, where 32 bits tell no centimetres apart: every path comes to its end.
TEST_F(TracedAtmosphereTest, EndsFarAway) {
  FrameRequest request = traced_picture(small_clouds(), {{0, 0, 60000}, 0, -7.6, 0}, {32, 16}, 16);
  request.lens.vertical_fov_deg = 0.5;
  EXPECT_GT(measured(traced(request)).mean, 0);
  EXPECT_GT(measured(traced(through_air(request))).mean, 0);
}

}  // namespace
}  // namespace cloudscape::render
