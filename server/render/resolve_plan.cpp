#include "render/resolve_plan.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/wind.h"
#include "render/discs.h"
#include "render/newly_seen.h"

namespace cloudscape::render {
namespace {

constexpr double degrees_per_radian = 180 / std::numbers::pi;

vec4 xyz_w(const glm::dvec3& xyz, double w) { return {xyz.x, xyz.y, xyz.z, w}; }
double fraction(double value) { return value - std::floor(value); }

int whole_blocks(int shown_px, int divisor, int stride) {
  const int kept = (shown_px + divisor - 1) / divisor;
  return (kept + stride - 1) / stride * stride;
}

bool same_light(const Cloudscape& a, const Cloudscape& b) {
  return a.sun == b.sun && a.moon == b.moon && a.sky == b.sky && a.medium == b.medium;
}

// tuned: samples in a pixel's average. A resting picture gathers until its noise is gone; a moving one forgets what it
// was re-projected from before that goes soft; a new light shows within some frames.
constexpr double resting_samples = 32, slow_samples = 16, moving_samples = 2, new_light_samples = 1;
// tuned: by how much of its range a neighbourhood of noisy samples is widened. Wider keeps what falls between the
// samples, and what has gone: the shape of a hill that one has flown past. A resting picture needs no bound at all.
constexpr double resting_margin = 1e4, slow_margin = 4, moving_margin = 0.6, new_light_margin = 0;
FrameRequest request_of_rays(const FrameRequest& asked, const ResolvePlan& plan, ImageSize size) {
  FrameRequest request = asked;
  request.size_px = size;
  request.lens.vertical_fov_deg = kept_view(asked, plan).vertical_fov_deg;
  request.sample_share = static_cast<double>(size.width) / plan.kept.width;
  request.quality.smooth = false;
  request.quality.march_divisor = 1;
  request.quality.samples = 1;
  return request;
}

}  // namespace

double half_height_of(double vertical_fov_deg) { return std::tan(0.5 * vertical_fov_deg / degrees_per_radian); }

bool same_clouds(const Cloudscape& a, const Cloudscape& b) {
  return a.volume == b.volume && a.noise == b.noise && a.shape == b.shape && a.detail == b.detail && a.seed == b.seed &&
         a.ground == b.ground;
}

double moved_m(const KeptView& now, const KeptView& before) {
  const glm::dvec2 drift = drift_m_per_s(*now.cloudscape) * (now.time_s - before.time_s);
  return glm::length(now.pose.position_m - before.pose.position_m - glm::dvec3(drift, 0));
}

bool continues_picture(const FrameRequest& request) {
  const RenderQuality& quality = request.quality;
  return (quality.reuse > 1 || quality.resolution_divisor > 1) && quality.technique == Technique::march &&
         request.lens.kind == LensKind::perspective && request.content == FrameContent::display;
}

ResolvePlan resolve_plan(const FrameRequest& request) {
  ResolvePlan plan;
  plan.shown = request.size_px;
  plan.divisor = request.quality.resolution_divisor;
  plan.stride = request.quality.reuse >= 16 ? 4 : request.quality.reuse >= 4 ? 2 : 1;
  plan.kept = {whole_blocks(plan.shown.width, plan.divisor, plan.stride),
               whole_blocks(plan.shown.height, plan.divisor, plan.stride)};
  plan.marched = {plan.kept.width / plan.stride, plan.kept.height / plan.stride};
  plan.margin_px = {0.5 * (plan.kept.width - static_cast<double>(plan.shown.width) / plan.divisor),
                    0.5 * (plan.kept.height - static_cast<double>(plan.shown.height) / plan.divisor)};
  return plan;
}

std::optional<Enlargement> enlargement_of(const ResolvePlan& plan) {
  if (plan.kept == plan.shown) return std::nullopt;
  return Enlargement{plan.kept, plan.divisor, plan.margin_px};
}

glm::ivec2 marched_pixel(int stride, std::uint64_t frame) {
  // One digit of base 4 is a place in 2x2, the lowest that of the largest squares.
  constexpr int columns[] = {0, 1, 1, 0}, rows[] = {0, 1, 0, 1};
  glm::ivec2 at(0);
  for (int square = stride / 2; square > 0; square /= 2, frame /= 4)
    at += square * glm::ivec2(columns[frame % 4], rows[frame % 4]);
  return at;
}

FrameRequest marched_request(const FrameRequest& asked, const ResolvePlan& plan) {
  return request_of_rays(asked, plan, plan.marched);
}

FrameRequest newly_seen_request(const FrameRequest& asked, const ResolvePlan& plan) {
  return request_of_rays(asked, plan, plan.kept);
}

glm::dvec2 marched_offset(const ResolvePlan& plan, std::uint64_t frame, bool resting) {
  const glm::dvec2 middle = glm::dvec2(marched_pixel(plan.stride, frame)) - 0.5 * (plan.stride - 1);
  // The R2 sequence (Roberts 2018), one number for all pixels of a round.
  const auto round = static_cast<double>(frame / static_cast<std::uint64_t>(plan.stride * plan.stride));
  const glm::dvec2 within(fraction(0.5 + 0.7548776662466927 * round) - 0.5,
                          fraction(0.5 + 0.5698402909980532 * round) - 0.5);
  return (middle + (resting ? within : glm::dvec2(0))) / static_cast<double>(plan.stride);
}

int marched_sample(const ResolvePlan& plan, std::uint64_t frame) {
  const auto round = static_cast<std::uint64_t>(plan.stride * plan.stride);
  // A step's start moves on by the golden ratio from sample to sample (shaders/render/march.glsl): by a quarter with
  // every second one, by a sixteenth with every 26th.
  const std::uint64_t between_pixels = plan.stride == 2 ? 2 : 26;
  return static_cast<int>((frame / round + between_pixels * (frame % round)) % 4096);
}

KeptView kept_view(const FrameRequest& asked, const ResolvePlan& plan) {
  const double taller = static_cast<double>(plan.kept.height) * plan.divisor / plan.shown.height;
  KeptView view;
  view.pose = asked.pose;
  view.vertical_fov_deg = 2 * std::atan(half_height_of(asked.lens.vertical_fov_deg) * taller) * degrees_per_radian;
  view.aspect = static_cast<double>(plan.kept.width) / plan.kept.height;
  view.time_s = asked.time_s;
  view.cloudscape = asked.cloudscape;
  return view;
}

ResolveBlock resolve_block(const ResolvePlan& plan, std::uint64_t frame, const KeptView& now,
                           const std::optional<KeptView>& before, bool resting) {
  const bool known = before && same_clouds(*before->cloudscape, *now.cloudscape);
  const KeptView& then = known ? *before : now;
  const CameraAxes axes = camera_axes(then.pose);
  const glm::dvec2 drift = drift_m_per_s(*now.cloudscape) * (now.time_s - then.time_s);
  const bool new_light = !same_light(*then.cloudscape, *now.cloudscape);
  const glm::ivec2 at = marched_pixel(plan.stride, frame);
  ResolveBlock block{};
  block.kept = {plan.kept.width, plan.kept.height, plan.stride, marches_newly_seen(plan, now, before)};
  block.before_right = xyz_w(axes.right, half_height_of(then.vertical_fov_deg));
  block.before_up = xyz_w(axes.up, then.aspect);
  block.before_forward = xyz_w(axes.forward, known);
  block.moved = xyz_w(now.pose.position_m - then.pose.position_m, half_height_of(now.vertical_fov_deg));
  resting = resting && known;
  const bool slow = now.time_s == then.time_s;  // where the view, too, hardly moves
  const double per_km = 0.001 * moved_m(now, then);
  const double parallax_px = per_km * 0.5 * plan.kept.height / half_height_of(now.vertical_fov_deg);
  block.drift = xyz_w(glm::dvec3(drift, 0), 1000 * most_newly_seen_closeness_per_m(moved_m(now, then)));
  block.marched = {at.x, at.y, resting ? 0 : 1, parallax_px};
  if (plan.stride > 1 && !resting) {
    const Discs discs = discs_of(now, plan.kept);
    block.sun = xyz_w(discs.sun_px, 0), block.moon = xyz_w(discs.moon_px, 0);
  }
  block.trust = {moving_samples, moving_samples, moving_margin, moving_margin};
  if (slow) block.trust.x = slow_samples, block.trust.z = slow_margin;
  if (resting) block.trust.x = resting_samples, block.trust.z = resting_margin;
  if (new_light) block.trust = {new_light_samples, new_light_samples, new_light_margin, new_light_margin};
  return block;
}

}  // namespace cloudscape::render
