#include "render/in_scatter_plan.h"

#include <algorithm>
#include <cmath>

#include "bake/in_scatter.h"
#include "render/block_values.h"

namespace cloudscape::render {
namespace {

// tuned: points upwards for each one across, by distance; light changes faster upwards. More take longer to solve.
constexpr double points_upwards = 1.5;
constexpr int fewest_layers = 8, most_layers = 48;
constexpr double most_points_alone = 100'000;  // tuned: of a body that stands alone, as deep as wide: 1 s to solve
constexpr int varied_levels = 3;  // tuned: light at the thresholds between is a mixture; more take longer to solve
// tuned against the path-traced reference: how much of the difference between the fine optical depth and the grid's is
// seen in the light of the other orders, where a point lies deeper than the grid knows.
constexpr double fine_shade = 0.5;

bool repeats(const Cloudscape& sky) {
  const VolumeKind kind = sky.volume.kind;
  return kind == VolumeKind::slab || (is_textured(kind) && sky.volume.tiling);
}

// Across a box that stands alone one point lies outside at either side.
void across(InScatterPlan& plan, int axis, int points) {
  plan.size[axis] = plan.periodic ? points : points + 2;
  plan.spacing[axis] = 1.0 / points;
  plan.first[axis] = (plan.periodic ? 0.5 : -0.5) / points;
}

// Upwards a point lies above and one below what is dense.
void upwards(InScatterPlan& plan, double lowest, double highest, int layers) {
  plan.size.z = layers + 2;
  plan.spacing.z = (highest - lowest) / layers;
  plan.first.z = lowest - 0.5 * plan.spacing.z;
}

// Points about `point_m` apart across, of volumes as thick as `thickness_m`.
glm::ivec3 counts(const Cloudscape& marched, double point_m, double thickness_m) {
  const bool even = marched.volume.kind == VolumeKind::slab;
  const auto across = [&](double size_m) {
    return even ? 4 : std::max(8, static_cast<int>(std::lround(size_m / point_m)));
  };
  const int layers = static_cast<int>(std::ceil(points_upwards * thickness_m / point_m));
  const glm::dvec3& size_m = marched.volume.size_m;
  return {across(size_m.x), across(size_m.y), std::clamp(layers, fewest_layers, most_layers)};
}

double product(const glm::ivec3& count) { return double(count.x) * count.y * count.z; }

}  // namespace

InScatterPlan in_scatter_plan(const Cloudscape& marched, double lowest, double highest, double threshold,
                              double swing) {
  InScatterPlan plan;
  const glm::dvec3& size_m = marched.volume.size_m;
  plan.periodic = repeats(marched);
  if (!(highest > lowest)) lowest = 0, highest = 1;  // no cloud anywhere
  const double thickness_m = (highest - lowest) * size_m.z;
  const double point_m = std::max(size_m.x, size_m.y) / marched.medium.light_model.volume_resolution;
  glm::ivec3 count = counts(marched, point_m, thickness_m);
  if (const double excess = product(count) / most_points_alone; !plan.periodic && excess > 1)
    count = counts(marched, point_m * std::cbrt(excess), thickness_m);
  for (int axis = 0; axis < 2; ++axis) across(plan, axis, count[axis]);
  upwards(plan, lowest, highest, count.z);
  plan.thresholds = {threshold};
  if (swing <= 0) return plan;
  plan.thresholds.clear();
  for (int level = 0; level < varied_levels; ++level)
    plan.thresholds.push_back(threshold + swing * (2.0 * level / (varied_levels - 1) - 1));
  return plan;
}

double mean_cosine(const Phase& phase, double mie_asymmetry_g) {
  switch (phase.kind) {
    case PhaseKind::henyey_greenstein:
      return phase.asymmetry_g;
    case PhaseKind::two_lobe:
      return std::lerp(phase.asymmetry_g, phase.second_asymmetry_g, phase.second_weight);
    case PhaseKind::mie:
      return mie_asymmetry_g;
    default:
      return 0;
  }
}

void set_in_scatter(CloudBlock& block, const InScatterPlan& plan) {
  const glm::dvec3 scale = 1.0 / (plan.spacing * glm::dvec3(plan.size));
  const glm::dvec3 offset = 0.5 / glm::dvec3(plan.size) - plan.first * scale;
  const auto levels = static_cast<double>(plan.thresholds.size());
  const double range = plan.thresholds.back() - plan.thresholds.front();
  block.in_scatter_scale = {scale.x, scale.y, scale.z, levels};
  block.in_scatter_offset = {offset.x, offset.y, offset.z, 0};
  block.in_scatter_levels = {plan.thresholds.front(), range > 0 ? (levels - 1) / range : 0, 0, fine_shade};
}

void set_mean_cosine(CloudBlock& block, double mean_cosine) {
  block.in_scatter_offset.w = static_cast<float>(mean_cosine);
  const double albedo = block.medium.x > 0 ? double(block.medium.y) / double(block.medium.x) : 0;
  block.in_scatter_levels.z = static_cast<float>(albedo * bake::scatter_moments(mean_cosine).forward_share);
}

}  // namespace cloudscape::render
