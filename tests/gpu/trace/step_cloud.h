// The step cloud of the Intercomparison of 3D Radiation Codes (I3RC), phase 1, case 1: strips of 250 m with optical
// depths 2 and 18, repeated without end; Henyey-Greenstein with g = 0.85 above a black surface. Its sharp edges make it
// a strong test of delta and ratio tracking: the bound is the thick strips' everywhere.
#pragma once
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "traced.h"

namespace cloudscape::render {

class StepCloud {
 public:
  // Of the flux of a sun at `zenith_deg`, by reciprocity: what one sees at that angle in a white sky above the black
  // surface.
  Measured flux(double zenith_deg, double albedo, bool reflected, int samples) {
    Cloudscape sky = cloud(albedo);
    sky.sun.irradiance = glm::dvec3(0);
    sky.sky = {SkyKind::uniform, glm::dvec3(1)};
    return seen(sky, zenith_deg, reflected, samples);
  }
  // pi times the radiance at nadir view over the flux of a sun at `zenith_deg`, at a right angle to the strips.
  Measured factor(double zenith_deg, int samples) {
    Cloudscape sky = cloud(1);
    sky.sun.elevation_deg = 90 - zenith_deg, sky.sun.azimuth_deg = 90;
    Measured measured = seen(sky, 0, true, samples);
    const double scale = std::numbers::pi / std::cos(radians(zenith_deg));
    measured.mean *= scale, measured.error *= scale;
    return measured;
  }

 private:
  // Above the ground so far that a picture from below, however it leans, fits in between.
  static Cloudscape cloud(double albedo) {
    Cloudscape sky = homogeneous(VolumeKind::grid, {0, 0, 300}, {500, 500, 250}, 18.0 / 250);
    VolumeGrid& grid = sky.volume.grid;
    grid.file = "step-cloud.raw", grid.size = {32, 1, 1}, grid.tiling = true;
    grid.interpolation = VoxelInterpolation::nearest;
    sky.medium.phase = {PhaseKind::henyey_greenstein, 0.85};
    sky.medium.single_scattering_albedo = albedo;
    sky.ground.kind = GroundKind::plain;
    sky.ground.albedo = glm::dvec3(0);
    return sky;
  }
  // The picture covers one period of the strips, which run from south to north.
  Measured seen(const Cloudscape& sky, double zenith_deg, bool from_above, int samples) {
    const double up = from_above ? -1 : 1;
    const CameraPose pose{{0, 0, from_above ? 1000.0 : 150.0}, 90, up * (90 - zenith_deg), 0};
    const FrameRequest request = traced_beam(sky, pose, 64, samples, 500 * std::cos(radians(zenith_deg)));
    return measured(stack_.renderer.render(request));
  }

  Stack stack_{gpu::PassExecution::automatic, {}, CLOUDSCAPE_SOURCE_DIR "/config/volumes"};
};

// Consensus means over the period; 0: not given.
struct StepCloudTruth {
  double zenith_deg, albedo, reflected, transmitted, factor;
};
constexpr StepCloudTruth step_cloud_truths[] = {
    {0, 1, 0.32760, 0.67240, 0.25640}, {60, 1, 0.58044, 0, 0.40607}, {60, 0.99, 0.47654, 0.32490, 0}};

}  // namespace cloudscape::render
