// The path tracer in homogeneous media, against closed forms.
#include "traced.h"

namespace cloudscape::render {
namespace {

constexpr double g = 0.5;
using Traced = TraceTest;

Cloudscape lit_from(Cloudscape sky, double azimuth_deg, double elevation_deg) {
  sky.medium.phase = {PhaseKind::henyey_greenstein, g};
  sky.sun.azimuth_deg = azimuth_deg;
  sky.sun.elevation_deg = elevation_deg;
  return sky;
}

// Light that passes unscattered, by the law of Bouguer, Lambert and Beer: a black ball before a white sky.
TEST_F(Traced, TransmittanceOfASphere) {
  for (const double t : {0.1, 0.5, 2.0}) {
    Cloudscape sky = ball(100, t);
    sky.medium.single_scattering_albedo = 0;
    sky.sky = {SkyKind::uniform, glm::dvec3(1)};
    const Frame frame = render(traced_beam(sky, {camera_m, 0, 0, 0}, 16, 1024));
    const Measured through = measured(frame);
    EXPECT_NEAR(through.mean, std::exp(-2 * t), 4 * through.error) << "optical radius " << t;
    EXPECT_LT(through.error, 0.02 * std::exp(-2 * t));
    EXPECT_NEAR(opacity(frame), 1 - through.mean, 0.05);
  }
}

// Single scattering, seen from the sun's side and against it (closed forms of a ball's middle).
TEST_F(Traced, SingleScatteringThroughTheMiddleOfASphere) {
  for (const double t : {0.1, 1.0, 5.0})
    for (const bool back : {true, false}) {
      FrameRequest request = traced_beam(lit_from(ball(100, t), back ? 180 : 0, 0), {camera_m, 0, 0, 0}, 16, 1024);
      request.tracing.max_scattering_order = 1;
      const Measured radiance = measured(render(request));
      const double expected = back ? henyey_greenstein(-1, g) * (1 - std::exp(-4 * t)) / 2
                                   : 2 * t * henyey_greenstein(1, g) * std::exp(-2 * t);
      EXPECT_NEAR(radiance.over(expected), 1, 4 * radiance.error / expected) << t << (back ? " back" : " forward");
    }
}

// Without absorption, in a sky that is the same all round, a medium cannot be seen.
TEST_F(Traced, WhiteFurnaceOfASphere) {
  for (const double t : {0.5, 5.0}) {
    Cloudscape sky = ball(100, t);
    sky.sky = {SkyKind::uniform, glm::dvec3(2)};
    sky.sun.irradiance = glm::dvec3(0);
    const Frame frame = render(traced_beam(sky, {camera_m, 0, 0, 0}, 8, 64, 190));
    for (int pixel = 0; pixel < 64; ++pixel) EXPECT_NEAR(red(frame, pixel), 2, 2e-5);
  }
}

}  // namespace
}  // namespace cloudscape::render
