// What holds for any medium: light that comes in goes out, and light takes the same way back.
#include "gpu/trace/slab_cases.h"

namespace cloudscape::render {
namespace {

using Conservation = TraceTest;

// Flux through the hemisphere that a fisheye sees, of the flux of a sun at the zenith.
Measured hemisphere_flux(const SlabTruth& truth, bool above, int side, int samples) {
  FrameRequest request =
      traced_picture(slab_of(truth), {{0, 0, above ? 1000.0 : 2.0}, 0, above ? -90.0 : 90.0, 0}, {side, side}, samples);
  request.lens.kind = LensKind::fisheye;
  const Frame frame = TraceTest::traced(request);
  Measured flux;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double r = std::hypot(2 * (x + 0.5) / side - 1, 2 * (y + 0.5) / side - 1);
      if (r > 1) continue;
      // An equidistant lens: the angle is r quarter turns.
      const double angle = 0.5 * std::numbers::pi * r, area = 4.0 / (side * side);
      const double weight = std::cos(angle) * std::sin(angle) * 0.5 * std::numbers::pi / r * area;
      const auto pixel = static_cast<std::size_t>(y * side + x);
      flux.mean += weight * frame.radiance_rgba[4 * pixel];
      flux.error += std::pow(weight * frame.standard_error_rgb[3 * pixel], 2);
    }
  flux.error = std::sqrt(flux.error);
  return flux;
}

TEST_F(Conservation, ReflectedAndTransmittedLightIsAllLight) {
  for (const SlabTruth& truth : {SlabTruth{0, 1, 1, 0.341329, 0.658671, 0}, SlabTruth{0.5, 4, 1, 0, 0, 0}}) {
    const Measured up = hemisphere_flux(truth, true, 64, 256), down = hemisphere_flux(truth, false, 64, 256);
    const double sum = up.mean + down.mean + std::exp(-truth.optical_thickness);
    std::printf(
        "| slab in the sun, g %.1f, optical thickness %.0f: reflected + transmitted | 1 | %.5f | %.2f %% | %+.2f %% "
        "|\n",
        truth.asymmetry_g, truth.optical_thickness, sum, 100 * std::hypot(up.error, down.error), 100 * (sum - 1));
    EXPECT_NEAR(sum, 1, 0.01);
    if (truth.reflected > 0) {
      EXPECT_NEAR(up.mean / truth.reflected, 1, 0.01);
    }
  }
}

// Light that a box scatters from one direction into another: the same as the other way round.
Measured scattered(const glm::dvec2& sun_deg, const glm::dvec2& out_deg) {
  const glm::dvec3 center(0, 0, 2000), size(300, 500, 200);
  Cloudscape sky = homogeneous(VolumeKind::box, center - 0.5 * size, size, 0.01);
  sky.medium.phase = {PhaseKind::henyey_greenstein, 0.7};
  sky.sun.azimuth_deg = sun_deg.x, sky.sun.elevation_deg = sun_deg.y;
  const double azimuth = radians(out_deg.x), elevation = radians(out_deg.y);
  const glm::dvec3 out(std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
                       std::sin(elevation));
  return measured(
      TraceTest::traced(traced_beam(sky, {center + 1500.0 * out, out_deg.x + 180, -out_deg.y, 0}, 64, 384, 640)));
}

TEST_F(Conservation, LightTakesTheSameWayBack) {
  const glm::dvec2 a(30, 55), b(250, 10);
  const Measured there = scattered(a, b), back = scattered(b, a);
  std::printf("| box, 3 by 5 by 2 optical depths: there / back | 1 | %.5f | %.2f %% | %+.2f %% |\n",
              there.mean / back.mean, 100 * std::hypot(there.error / there.mean, back.error / back.mean),
              100 * (there.mean / back.mean - 1));
  EXPECT_NEAR(there.mean / back.mean, 1, 0.01);
}

}  // namespace
}  // namespace cloudscape::render
