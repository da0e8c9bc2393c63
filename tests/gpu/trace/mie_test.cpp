// The phase function of droplets in the path tracer: sampled by colour, against closed forms and a plane-parallel Monte
// Carlo calculation of its own in double precision.
#include <algorithm>
#include <random>

#include "bake/mie_phase.h"
#include "bake/phase_sampling.h"
#include "slab_cases.h"

namespace cloudscape::render {
namespace {

using TracedMie = TraceTest;
constexpr double radius_um = 4;

const bake::PhaseTable& table() {
  static const bake::PhaseTable known = *bake::mie_phase_table({.effective_radius_um = radius_um});
  return known;
}

Cloudscape mie_slab(double optical_thickness) {
  Cloudscape sky = slab_of({0, optical_thickness, 1, 0, 0, 0});
  sky.medium.phase = {.kind = PhaseKind::mie, .effective_radius_um = radius_um};
  return sky;
}

// Cosines drawn by bisection of the distribution of the table's cells.
class Cosines {
 public:
  explicit Cosines(std::size_t colour) : ends_(bake::cell_energies(table(), colour)) {
    for (std::size_t i = 1; i < ends_.size(); ++i) ends_[i] += ends_[i - 1];
  }
  double draw(std::mt19937_64& random) const {
    std::uniform_real_distribution<double> unit(0, 1);
    const auto cell = std::upper_bound(ends_.begin(), ends_.end() - 1, unit(random) * ends_.back()) - ends_.begin();
    const double share = unit(random);
    return std::lerp(at(static_cast<double>(cell)), at(static_cast<double>(cell + 1)), share);
  }

 private:
  static double at(double cell) { return std::cos(bake::phase_angle_rad(cell / bake::phase_table_cells)); }
  std::vector<double> ends_;
};

// Share of a beam from the zenith that a slab reflects: photons by optical depth and cosine to the vertical.
double reflected_by(const Cosines& cosines, double optical_thickness, int photons) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  int reflected = 0;
  for (int photon = 0; photon < photons; ++photon) {
    double depth = 0, down = 1;
    for (;;) {
      depth -= down * std::log(1 - unit(random));
      if (depth < 0 || depth > optical_thickness) break;
      const double mu = cosines.draw(random), turn = 2 * std::numbers::pi * unit(random);
      down = std::clamp(down * mu + std::sqrt((1 - down * down) * (1 - mu * mu)) * std::cos(turn), -1.0, 1.0);
    }
    reflected += depth < 0;
  }
  return static_cast<double>(reflected) / photons;
}

TEST_F(TracedMie, SlabsReflectAsPhotonsDo) {
  const double optical_thickness = 6;
  Cloudscape sky = mie_slab(optical_thickness);
  sky.sun.irradiance = glm::dvec3(0);
  sky.sky = {SkyKind::uniform, glm::dvec3(1)};
  sky.ground.kind = GroundKind::plain;
  sky.ground.albedo = glm::dvec3(0);
  const Frame frame = traced(traced_beam(sky, {{0, 0, 1000}, 0, -90, 0}, 64, 32));
  for (std::size_t colour = 0; colour < 3; ++colour) {
    const int photons = 200000;
    const double expected = reflected_by(Cosines(colour), optical_thickness, photons);
    const Measured got = measured(frame, colour);
    EXPECT_NEAR(got.mean, expected, 4 * std::hypot(got.error, std::sqrt(expected * (1 - expected) / photons)));
  }
}

// Single scattering of a slab, sun at the zenith, seen from above at a slant: the closed form with the table's value.
TEST_F(TracedMie, ScattersOnceByTheTable) {
  const double optical_thickness = 1;
  for (const double elevation_deg : {-50.0, -85.0}) {
    FrameRequest request = traced_beam(mie_slab(optical_thickness), {{0, 0, 1000}, 0, elevation_deg, 0}, 32, 64);
    request.tracing.max_scattering_order = 1;
    const Frame frame = traced(request);
    const double mu = std::sin(radians(-elevation_deg));
    const auto phase = table().at(radians(90 - elevation_deg));
    for (std::size_t colour = 0; colour < 3; ++colour) {
      const double expected = phase[colour] / (mu + 1) * (1 - std::exp(-optical_thickness * (1 / mu + 1)));
      const Measured got = measured(frame, colour);
      EXPECT_NEAR(got.over(expected), 1, 0.005 + 4 * got.error / expected);
    }
  }
}

TEST_F(TracedMie, WhiteFurnace) {
  Cloudscape sky = mie_slab(8);
  sky.sun.irradiance = glm::dvec3(0);
  sky.sky = {SkyKind::uniform, glm::dvec3(1)};
  sky.ground.kind = GroundKind::none;
  const Frame frame = traced(traced_beam(sky, {{0, 0, 1000}, 0, -70, 0}, 48, 64));
  for (std::size_t colour = 0; colour < 3; ++colour) {
    const Measured got = measured(frame, colour);
    EXPECT_NEAR(got.mean, 1, 4 * got.error + 2e-4);
  }
}

}  // namespace
}  // namespace cloudscape::render
