// The Mie phase function in pictures, against the table in double precision.
#include <array>

#include "bake/mie_phase.h"
#include "fixture.h"

namespace cloudscape::render {
namespace {

using Mie = RenderTest;

// A ball so thin that its radiance is the phase function times its optical depth. The camera looks north: the sun's
// azimuth is the scattering angle.
constexpr double optical_radius = 0.001;
Cloudscape thin_ball(double angle_deg) {
  Cloudscape sky = ball(100, optical_radius);
  sky.medium.phase = {.kind = PhaseKind::mie, .effective_radius_um = 4};
  sky.sun.azimuth_deg = angle_deg, sky.sun.elevation_deg = 0;
  return sky;
}

std::array<double, 3> phase_of(const Frame& frame) {
  std::array<double, 3> phase;
  for (std::size_t i = 0; i < 3; ++i) phase[i] = frame.radiance_rgba[i] / (2 * optical_radius);
  return phase;
}

TEST_F(Mie, EveryColourHasItsPhaseFunction) {
  const bake::PhaseTable table =
      bake::seen_by_disc(*bake::mie_phase_table({.effective_radius_um = 4}), radians(Sun{}.angular_radius_deg));
  for (const double angle_deg : {0.0, 1.0, 20.0, 90.0, 135.0, 143.0, 176.5, 179.5, 180.0}) {
    const auto found = phase_of(render(one_ray(thin_ball(angle_deg), {camera_m, 0, 0, 0})));
    const auto known = table.at(radians(angle_deg));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i] / known[i], 1, 0.005) << angle_deg << " colour " << i;
  }
}

// Multiple scattering washes the bow out: higher orders are of a Henyey-Greenstein function with the droplets' g.
TEST_F(Mie, TheOrdersAboveTheFirstHaveItsMeanCosine) {
  Cloudscape sky = thin_ball(143);
  const auto first = phase_of(render(one_ray(sky, {camera_m, 0, 0, 0})));
  sky.medium.light_model = {.kind = LightModelKind::beer_octaves,
                            .octaves = 2,
                            .octave_scattering = 0.5,
                            .octave_extinction = 0.5,
                            .octave_asymmetry = 0.5};
  const auto both = phase_of(render(one_ray(sky, {camera_m, 0, 0, 0})));
  const double g = bake::mie_phase_table({.effective_radius_um = 4})->mean_asymmetry_g();
  const double second = 0.5 * henyey_greenstein(std::cos(radians(143)), 0.5 * g);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR((both[i] - first[i]) / second, 1, 0.01);
}

TEST_F(Mie, ADocumentWithAnotherPhaseFunctionComputesNone) {
  Cloudscape sky = thin_ball(90);
  for (const PhaseKind kind : {PhaseKind::none, PhaseKind::isotropic}) {
    sky.medium.phase = {.kind = kind, .effective_radius_um = 33};
    const auto found = phase_of(render(one_ray(sky, {camera_m, 0, 0, 0})));
    for (const double phase : found) EXPECT_NEAR(phase * 4 * std::numbers::pi, 1, 0.005);
  }
  EXPECT_EQ(stack().bakes.phases().jobs(), 0U);
}

// A frame that must wait for its table lets others go before it.
TEST_F(Mie, TheRendererIsFreeWhileATableIsComputed) {
  Cloudscape sky = thin_ball(90);
  sky.medium.phase.effective_radius_um = 45;
  FrameRequest slow = one_ray(sky, {camera_m, 0, 0, 0});
  auto job = renderer().begin(slow);
  while (!job->baked) renderer().advance(*job);
  EXPECT_FALSE(job->phase);
  EXPECT_FALSE(renderer().advance(*job));
  EXPECT_GT(opacity(render(one_ray(ball(100, 1), {camera_m, 0, 0, 0}))), 0);
  while (!renderer().advance(*job)) continue;
  EXPECT_GT(red(renderer().collect(renderer().finish(std::move(job)))), 0);
  renderer().forget(slow.stream);
}

}  // namespace
}  // namespace cloudscape::render
