// Plane-parallel clouds whose reflection and transmission are known: published, or solved by adding and doubling, which
// agrees with what is published to five digits.
#pragma once
#include "traced.h"

namespace cloudscape::render {

// The sun at the zenith. Fluxes of the incident flux; factor: pi times the radiance at nadir view, over that of a white
// diffuse surface; 0: not given.
struct SlabTruth {
  double asymmetry_g, optical_thickness, albedo, reflected, transmitted, factor;
};
constexpr SlabTruth slab_truths[] = {
    {0, 1, 1, 0.341329, 0.658671, 0},            // van de Hulst 1980, table 12
    {0.5, 1, 0.9, 0, 0.739091, 0},               // van de Hulst 1980, table 35
    {0.75, 1, 0.9, 0, 0.827917, 0},              // the same
    {0.75, 2, 0.9, 0.097395, 0.660958, 0},       // the same; the case of Wang, Jacques, Zheng 1995 (MCML)
    {0.75, 1, 1, 0.078740, 0.921260, 0},         // Stamnes et al. 1988 (DISORT), test 3a
    {0.75, 8, 1, 0.506415, 0.493585, 0},         // the same, 3b
    {0.85, 1, 1, 0.042316, 0.957684, 0.017628},  // adding and doubling, this and the next
    {0.85, 4, 1, 0.190915, 0.809085, 0.131695},
    {0.85, 16, 1, 0.557209, 0.442791, 0.565456},
    {0, 16, 1, 0.903632, 0.096368, 0.935581},
};

constexpr double slab_bottom_m = 10,
                 slab_thickness_m = 500;  // low, so that the black planet below hides the sky to the horizon

inline Cloudscape slab_of(const SlabTruth& truth) {
  Cloudscape sky = homogeneous(VolumeKind::slab, {0, 0, slab_bottom_m}, {1000, 1000, slab_thickness_m},
                               truth.optical_thickness / slab_thickness_m);
  sky.medium.phase = {PhaseKind::henyey_greenstein, truth.asymmetry_g};
  sky.medium.single_scattering_albedo = truth.albedo;
  sky.sun.elevation_deg = 90;
  return sky;
}

// Above a black planet in a white sky, without a sun: looking straight down one sees, by reciprocity, the reflected
// flux of a sun at the zenith; looking straight up from below, the transmitted.
inline Measured slab_flux(const SlabTruth& truth, bool reflected, int side, int samples) {
  Cloudscape sky = slab_of(truth);
  sky.sun.irradiance = glm::dvec3(0);
  sky.sky = {SkyKind::uniform, glm::dvec3(1)};
  sky.ground.kind = GroundKind::plain;
  sky.ground.albedo = glm::dvec3(0);
  const CameraPose above{{0, 0, 1000}, 0, -90, 0}, below{{0, 0, 2}, 0, 90, 0};
  return measured(TraceTest::traced(traced_beam(sky, reflected ? above : below, side, samples)));
}

// What is seen straight down, lit by the sun at the zenith.
inline Measured slab_factor(const SlabTruth& truth, int side, int samples) {
  Measured factor = measured(TraceTest::traced(traced_beam(slab_of(truth), {{0, 0, 1000}, 0, -90, 0}, side, samples)));
  factor.mean *= std::numbers::pi, factor.error *= std::numbers::pi;
  return factor;
}

}  // namespace cloudscape::render
