// The cloud block: the medium as the march sees it from one camera at one time.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/bake_size.h"
#include "core/march_steps.h"
#include "core/wind.h"
#include "render/block_values.h"

namespace cloudscape::render {
namespace {

vec4 xyz_w(const glm::dvec3& xyz, double w) { return {xyz.x, xyz.y, xyz.z, w}; }
double fraction(double value) { return value - std::floor(value); }

// How far the wind has moved the clouds, m.
glm::dvec2 wind_drift(const FrameRequest& request) { return drift_m_per_s(*request.cloudscape) * request.time_s; }

// A pattern that repeats, seen from a point: 1 / period, and where in its period the point lies. The whole periods are
// taken off in double precision, so that neither far ways nor long times are seen.
vec4 repeating(double period_m, const glm::dvec3& at_m) {
  return {1 / period_m, fraction(at_m.x / period_m), fraction(at_m.y / period_m), fraction(at_m.z / period_m)};
}

// Where the point below the camera lies in a pattern that drifts with the wind, m.
glm::dvec2 drifted(const FrameRequest& request) { return glm::dvec2(request.pose.position_m) - wind_drift(request); }

vec4 tile_of(const Volume& volume, const glm::dvec2& at_m) {
  glm::dvec2 tile{(at_m.x - volume.origin_m.x) / volume.size_m.x, (at_m.y - volume.origin_m.y) / volume.size_m.y};
  if (volume.tiling) tile = {fraction(tile.x), fraction(tile.y)};
  return {1 / volume.size_m.x, 1 / volume.size_m.y, tile.x, tile.y};
}

struct Octaves {
  vec4 low{0}, high{0};
  void set(int octave, double value) { (octave < 4 ? low : high)[octave % 4] = static_cast<float>(value); }
};

void set_light_model(CloudBlock& block, const LightModel& light) {
  Octaves weight, extinction, asymmetry;
  for (int octave = 0; octave < light.octaves; ++octave) {
    weight.set(octave, std::pow(light.octave_scattering, octave));
    extinction.set(octave, std::pow(light.octave_extinction, octave));
    asymmetry.set(octave, std::pow(light.octave_asymmetry, octave));
  }
  block.octave_weight_low = weight.low, block.octave_weight_high = weight.high;
  block.octave_extinction_low = extinction.low, block.octave_extinction_high = extinction.high;
  block.octave_asymmetry_low = asymmetry.low, block.octave_asymmetry_high = asymmetry.high;
  block.olajos = {light.olajos_attenuation, light.olajos_in_scatter, light.olajos_gain, 0};
  block.olajos_dark = xyz_w(light.olajos_dark, 0), block.olajos_bright = xyz_w(light.olajos_bright, 0);
}

double threshold_of(const Cloudscape& sky, const bake::BakedCloudscape& baked) {
  if (is_layered(sky)) return bake::common_threshold - mean_erosion(sky);
  if (sky.shape.threshold) return *sky.shape.threshold;
  return baked.threshold_for(sky.shape.coverage, mixing_weights(sky)) - mean_erosion(sky);
}

// Share of the sky that has cloud before it, of layers that stand independently above one another.
double cloud_cover(const Cloudscape& sky) {
  if (sky.volume.kind != VolumeKind::noise) return 0;
  double cover = sky.shape.coverage;
  for (const Layer& layer : sky.layers) cover += (1 - cover) * layer.coverage;
  return cover;
}

// tuned: the share of a tile by which the variation moves it; a third hides repetition without smearing shapes.
constexpr double variation_shift = 0.35;

// Half of how far the threshold swings. tuned: half the threshold is enough to open and close the sky.
double swing_of(const CoverageVariation& slow) { return slow.amount * 0.25; }

// Altitudes between which there is cloud anywhere.
glm::dvec2 cloud_altitudes_m(const Cloudscape& sky, const bake::BakedCloudscape& baked) {
  const Volume& volume = sky.volume;
  const double lowest_threshold = threshold_of(sky, baked) - swing_of(sky.shape.coverage_variation);
  const bake::HeightRange range = bake::heights_above(baked.extent(mixing_weights(sky)), lowest_threshold);
  return {volume.origin_m.z + range.low * volume.size_m.z, volume.origin_m.z + range.high * volume.size_m.z};
}

void set_shape(CloudBlock& block, const FrameRequest& request, const bake::BakedCloudscape& baked) {
  const Cloudscape& sky = *request.cloudscape;
  const glm::dvec2 at_m = drifted(request);
  const std::array<double, 3> weights = mixing_weights(sky);
  const CoverageVariation& slow = sky.shape.coverage_variation;
  block.shape = {threshold_of(sky, baked), sky.shape.edge_softness, 2 * swing_of(slow),
                 sky.volume.tiling ? variation_shift : 0.0};
  block.weights = {1, weights[0], weights[1], weights[2]};
  const double period_m = 4 * slow.wavelength_m;  // shaders/bake/variation.comp
  const Evolution moved = evolution(sky.wind, request.time_s);
  block.variation = repeating(period_m, glm::dvec3(at_m - moved.coverage_m, 0));
  block.detail = repeating(sky.detail.period_m, glm::dvec3(at_m, 0) - moved.detail_m);
  // The same texture again, finer. tuned: the ratio is no whole number, so that the two never line up.
  block.fine_detail = repeating(sky.detail.period_m / 4.7, glm::dvec3(at_m, 0) - moved.fine_detail_m);
  block.lean = {lean_m(sky).x, lean_m(sky).y, 0, 0};
  // tuned: steps longer than half a detail tile would sample it at random; its finest part is worth its cost up close.
  // tuned: shape noise changes by about this much a metre, so that samples far apart do not fall through thin edges.
  constexpr double shape_per_m = 1.2e-4;
  block.erosion = {sky.detail.strength, 0.5 * sky.detail.period_m, 0.1 * sky.detail.period_m, shape_per_m};
  if (is_from_file(sky.volume.kind)) block.erosion = vec4(0);  // voxels are what they are
}

// The longest large step that leaves out no cloud: twice the padding, since a cloud between two points is near one of
// them, less what the land's variation and the clouds' lean bend the tile on the way (Olajos 2.4.2 has one cell, which
// is always less).
double longest_large_step_m(const Cloudscape& sky, const bake::BakedCloudscape& baked) {
  const glm::dvec3 cells(baked.structure_size());
  const double across = lean_stretch(sky);
  const glm::dvec3 cell_m = sky.volume.size_m / cells / glm::dvec3(across, across, 1);
  const double padding_m = bake::structure_padding * std::min({cell_m.x, cell_m.y, cell_m.z});
  if (sky.shape.coverage_variation.amount <= 0 || !sky.volume.tiling) return 2 * padding_m;
  const double period_m = 4 * sky.shape.coverage_variation.wavelength_m;
  const double bend = variation_shift * std::max(sky.volume.size_m.x, sky.volume.size_m.y) *
                      baked.steepest_variation().shift / period_m;
  return 2 * padding_m / (1 + bend);
}

// A whole number of small steps where these have one length, so that the samples inside lie where they would without
// the structure.
double whole_steps(double length_m, const March& march) {
  return march.step_m ? std::floor(length_m / *march.step_m) * *march.step_m : length_m;
}

// 0: no large steps.
double large_step_m(const March& march, double longest_m) {
  return march.structure ? whole_steps(std::min(march.large_step_m.value_or(longest_m), longest_m), march) : 0;
}

// tuned: light from farther than this is diffuse anyway. In voxels all of the way counts; where they tile, as far as
// the sun at 3 degrees shines through them.
double light_length_m(const Volume& volume, const March& march) {
  if (volume.kind == VolumeKind::noise)
    return march.light_length_m.value_or(std::clamp(1.5 * volume.size_m.z, 800.0, 4000.0));
  if (!is_from_file(volume.kind)) return 1e7;
  return march.light_length_m.value_or(volume.grid.tiling ? 20 * volume.size_m.z : 1e7);
}

// tuned: the in-scatter volume knows what is farther than some of its points better than a few samples do, and what is
// nearer worse. Formulas need no samples.
double marched_light_m(const Cloudscape& sky, const March& march) {
  const double length_m = light_length_m(sky.volume, march);
  const bool textured = is_textured(sky.volume.kind);
  const LightModel& light = sky.medium.light_model;
  if (!textured || light.kind != LightModelKind::in_scatter_volume) return length_m;
  return std::min(length_m, 6 * std::max(sky.volume.size_m.x, sky.volume.size_m.y) / light.volume_resolution);
}

// A way in the world is at most so much longer in the tile: by the clouds' lean, the land's shift and the layer's bend.
double stretch_in_tile(const Cloudscape& sky, const bake::BakedCloudscape& baked) {
  constexpr double bend = 1.01;  // of the planet's curve over what a march sees: 60 km of 6371
  const double tile_m = std::max(sky.volume.size_m.x, sky.volume.size_m.y);
  return bend * (lean_stretch(sky) + land_slopes(sky, baked).shift_per_m * tile_m);
}

void set_distance(CloudBlock& block, const FrameRequest& request, const bake::BakedCloudscape& baked) {
  const bake::DistancePlan plan = distance_plan_of(*request.cloudscape, baked);
  block.distance = {1 / stretch_in_tile(*request.cloudscape, baked), plan.lowest_threshold, 1 / plan.between_levels,
                    plan.levels};
}

// A grid may be smaller than the quality's steps, and far away: half of the steps take a ray through it from corner to
// corner, unless they would be shorter than half a voxel.
double longest_step_m(const Volume& volume, const March& march, int max_steps, const bake::BakedCloudscape& baked) {
  constexpr double any = 1e9;
  if (!baked.grid() || volume.grid.tiling || march.step_m) return any;
  const glm::dvec3 voxel_m = volume.size_m / glm::dvec3(baked.grid()->size);
  return std::max(2 * glm::length(volume.size_m) / max_steps, 0.5 * std::min({voxel_m.x, voxel_m.y, voxel_m.z}));
}

void set_march(CloudBlock& block, const FrameRequest& request, const bake::BakedCloudscape& baked) {
  const Cloudscape& sky = *request.cloudscape;
  const March& march = request.march;
  const RenderQuality& quality = request.quality;
  const bool textured = is_textured(sky.volume.kind);
  const bool endless = sky.volume.kind == VolumeKind::noise || (textured && sky.volume.grid.tiling);
  const MarchSteps steps = march_steps(march, quality);
  const double longest_m = longest_step_m(sky.volume, march, steps.view, baked);
  block.volume.x = static_cast<float>(longest_m);
  block.steps = {std::min(march.step_m.value_or(quality.step_m), longest_m), march.step_m ? 0.0 : quality.step_growth,
                 steps.view, steps.light};
  block.adaptive = {march.adaptive_start_m, march.adaptive_step ? march.adaptive_growth : 0.0, march.random_first_step,
                    march.lighting};
  const glm::dvec2 altitudes_m = textured ? cloud_altitudes_m(sky, baked) : glm::dvec2(0);
  block.march = {marched_light_m(sky, march), endless ? march.max_distance_m : 1e8, altitudes_m.x, altitudes_m.y};
  const double large_m = textured ? large_step_m(march, longest_large_step_m(sky, baked)) : 0.0;
  const double period_m = 4 * sky.shape.coverage_variation.wavelength_m;
  // How much lower the threshold can be half a large step away.
  const double slack =
      block.shape.z * baked.steepest_variation().threshold / period_m * 0.5 * large_m * lean_stretch(sky);
  // From the last point outside, cloud is at least this far: half the longest large step; from one in the outer layer
  // of the padding the share that the other layers have of that.
  const double free_m = textured ? 0.5 * longest_large_step_m(sky, baked) : 0.0;
  const double inner_m = free_m * (bake::structure_padding - 1) / bake::structure_padding;
  block.structure = {large_m, slack, whole_steps(std::min(free_m, large_m), march), whole_steps(inner_m, march)};
}

}  // namespace

glm::dvec2 drift_of_clouds(const FrameRequest& request) {
  const VolumeKind kind = request.cloudscape->volume.kind;
  return is_textured(kind) ? wind_drift(request) : glm::dvec2(0);
}

// A shape of one channel is mixed when it is baked, or comes from a file; the channels that it has not read as 0, 0
// and 1. Nor is density mixed in.
std::array<double, 3> mixing_weights(const Cloudscape& sky) {
  if (shape_format(sky) != ShapeFormat::rgba8) return {};
  const auto& channels = sky.noise.channels;
  return {channels[1].weight, channels[2].weight, channels[3].weight};
}

LandSlopes land_slopes(const Cloudscape& sky, const bake::BakedCloudscape& baked) {
  const CoverageVariation& slow = sky.shape.coverage_variation;
  if (slow.amount <= 0) return {};
  const double period_m = 4 * slow.wavelength_m;
  const auto steepest = baked.steepest_variation();
  const double across = lean_stretch(sky);
  return {sky.volume.tiling ? across * variation_shift * steepest.shift / period_m : 0,
          across * 2 * swing_of(slow) * steepest.threshold / period_m};
}

bake::DistancePlan distance_plan_of(const Cloudscape& marched, const bake::BakedCloudscape& baked) {
  const double threshold = threshold_of(marched, baked), swing = swing_of(marched.shape.coverage_variation);
  bake::DistancePlan plan = bake::distance_plan(threshold - swing, threshold + swing);
  plan.weights = mixing_weights(marched);
  plan.size_m = marched.volume.size_m;
  plan.jumps = is_from_file(marched.volume.kind) && marched.volume.grid.interpolation == VoxelInterpolation::nearest;
  plan.threshold_fall_per_m = land_slopes(marched, baked).threshold_per_m / lean_stretch(marched);
  return plan;
}

InScatterPlan in_scatter_plan_of(const Cloudscape& marched, const bake::BakedCloudscape& baked) {
  const VolumeKind kind = marched.volume.kind;
  if (!is_textured(kind)) return in_scatter_plan(marched, 0, 1, 0, 0);
  const glm::dvec2 altitudes_m = cloud_altitudes_m(marched, baked);
  const Volume& volume = marched.volume;
  return in_scatter_plan(marched, (altitudes_m.x - volume.origin_m.z) / volume.size_m.z,
                         (altitudes_m.y - volume.origin_m.z) / volume.size_m.z, threshold_of(marched, baked),
                         swing_of(marched.shape.coverage_variation));
}

CloudBlock cloud_block(const FrameRequest& asked, const bake::BakedCloudscape& baked) {
  const FrameRequest request = as_marched(asked, baked);
  const Cloudscape& sky = *request.cloudscape;
  const Volume& volume = sky.volume;
  const bool from_file = is_from_file(volume.kind);
  const glm::dvec3 below_camera(from_file ? drifted(request) : glm::dvec2(request.pose.position_m), 0);
  CloudBlock block;
  block.layer = {volume.origin_m.z, volume.origin_m.z + volume.size_m.z, 1 / volume.size_m.z,
                 static_cast<int>(from_file ? VolumeKind::vdb : volume.kind)};
  block.tile = tile_of(volume, drifted(request));
  block.box_low = xyz_w(volume.origin_m - below_camera, volume.tiling);
  block.box_high = xyz_w(volume.origin_m + volume.size_m - below_camera, 0);
  block.volume = {0, !from_file, cloud_cover(sky), is_layered(sky)};
  set_shape(block, request, baked);
  const Medium& medium = sky.medium;
  block.medium = {medium.extinction_per_m, medium.extinction_per_m * medium.single_scattering_albedo, medium.ambient,
                  static_cast<int>(medium.phase.kind)};
  block.phase = {medium.phase.asymmetry_g, medium.phase.second_asymmetry_g, medium.phase.second_weight,
                 static_cast<int>(medium.light_model.kind)};
  set_light_model(block, medium.light_model);
  set_march(block, request, baked);
  if (is_textured(volume.kind) && request.march.distance_field) set_distance(block, request, baked);
  set_in_scatter(block, in_scatter_plan_of(sky, baked));
  return block;
}

}  // namespace cloudscape::render
