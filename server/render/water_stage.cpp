#include "render/water_stage.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "render/block_values.h"

namespace cloudscape::render {
namespace {

using gpu::Binding, gpu::Format, gpu::Texture;

// tuned: a texel is 1.4 degrees wide, which waves blur; a slice is about 10 ms on two cores.
constexpr ImageSize panorama_size{256, 128};
constexpr int rows = 64, levels = 6, rows_per_slice = 8;
constexpr std::size_t most_panoramas = 16;  // tuned: streams over different places of a few documents
constexpr double eye_above_m = 2;           // the water, so that it does not see below it

// Altitude of most of the clouds above the water, m: nearer their base, which is what shows.
double clouds_above_m(const FrameRequest& request, const CloudBlock& cloud) {
  const bool textured = cloud.march.w > cloud.march.z;
  const double low_m = textured ? cloud.march.z : cloud.box_low.z, high_m = textured ? cloud.march.w : cloud.box_high.z;
  return std::max(std::lerp(low_m, high_m, 0.3) - *request.cloudscape->ground.water.level_m, 100.0);
}

// tuned: as far from the place as the clouds are a quarter of their altitude away, what is moved to it stays
// believable.
glm::dvec2 eye_of(const FrameRequest& request, double altitude_m) {
  const double spacing_m = std::clamp(0.25 * altitude_m, 50.0, 2000.0);
  const glm::dvec2 at_m = glm::dvec2(request.pose.position_m) - drift_of_clouds(request);
  return spacing_m * glm::round(at_m / spacing_m);
}

// The panorama as a request: of the clouds at time 0, which have not drifted.
FrameRequest seen_from_water(const FrameRequest& request, const glm::dvec2& eye_m) {
  FrameRequest seen;
  seen.cloudscape = request.cloudscape;
  seen.march = request.march;
  seen.pose = {{eye_m, *request.cloudscape->ground.water.level_m + eye_above_m}, 0, 0, 0};
  seen.lens.kind = LensKind::panorama;
  seen.size_px = panorama_size;
  seen.quality = {.max_steps = 96, .step_m = 80, .step_growth = 0.04, .light_steps = 4};
  return seen;
}

std::unique_ptr<Targets> panorama_targets() {
  RenderQuality quality;
  return TargetPool().acquire(panorama_size, quality);
}

std::shared_ptr<CloudPanorama> new_panorama(const glm::dvec2& eye_m, double altitude_m) {
  auto panorama = std::make_shared<CloudPanorama>();
  panorama->clouds = Texture(Format::rgba32f, panorama_size.width, rows, "clouds in water", levels);
  panorama->clouds.sample_with(gpu::Filter::linear, gpu::Wrap::repeat, gpu::Wrap::clamp);
  panorama->eye_m = eye_m, panorama->altitude_m = altitude_m;
  return panorama;
}

bool has_clouds(const CloudBlock& cloud) { return cloud.medium.x > 0; }

}  // namespace

WaterStage::WaterStage(const gpu::Context& context, gpu::ShaderLibrary& shaders)
    : gather_(context, shaders, "render/water_clouds.glsl", {Format::rgba32f}),
      frame_block_("frame above the water"),
      cloud_block_("cloud above the water"),
      block_("water") {}

// Clouds in light that may lag are rendered one light after the other, each to its end.
WaterStage::Entry& WaterStage::entry_of(const Scene& scene) {
  const FrameRequest& request = scene.request;
  const double altitude_m = clouds_above_m(request, scene.cloud);
  const glm::dvec2 eye_m = eye_of(request, altitude_m);
  const auto same = [&](const Entry& entry) {
    return entry.panorama->eye_m == eye_m && entry.march == request.march &&
           entry.in_scatter.lock() == scene.in_scatter && entry.sun_depth.lock() == scene.sun_depth &&
           (entry.cloudscape == request.cloudscape || *entry.cloudscape == *request.cloudscape);
  };
  auto found = std::ranges::find_if(entries_, same);
  if (found == entries_.end() && request.light_may_lag) {
    found = std::ranges::find_if(
        entries_, [&](const Entry& entry) { return entry.targets && is_of_clouds(entry, *request.cloudscape); });
    if (found != entries_.end()) found->in_scatter.reset(), found->sun_depth.reset();  // of more lights than one
  }
  if (found == entries_.end()) {
    ++panoramas_made_;
    entries_.push_front({request.cloudscape, request.march, scene.in_scatter, scene.sun_depth,
                         new_panorama(eye_m, altitude_m), panorama_targets(), 0});
    drop_oldest();
    return entries_.front();
  }
  entries_.splice(entries_.begin(), entries_, found);
  return entries_.front();
}

// One that is done, if there is one: others are being waited for.
void WaterStage::drop_oldest() {
  if (entries_.size() <= most_panoramas) return;
  const auto done = std::find_if(entries_.rbegin(), entries_.rend(), [](const Entry& entry) { return !entry.targets; });
  entries_.erase(done == entries_.rend() ? std::prev(entries_.end()) : std::prev(done.base()));
}

void WaterStage::render_slice(const Scene& scene, const SkyTables::Set& sky, Entry& entry) {
  const FrameRequest seen = seen_from_water(scene.request, entry.panorama->eye_m);
  FrameBlock frame = frame_block(seen, 0);
  CloudBlock cloud = cloud_block(seen, scene.medium.baked);
  cloud.phase.x = scene.cloud.phase.x;
  cloud.in_scatter_offset.w = scene.cloud.in_scatter_offset.w;
  frame.ground.x = static_cast<float>(GroundKind::none);  // land stands in no cloud's way
  frame_block_.upload(frame), frame_block_.bind();
  cloud_block_.upload(cloud), cloud_block_.bind();
  const int end = std::min(entry.next_row + rows_per_slice, rows);
  PassClock untimed;
  scene.passes.march(*entry.targets, sky, scene.medium, entry.next_row, end, untimed);
  entry.next_row = end;
  if (end < rows) return;
  const Texture* target[] = {&entry.panorama->clouds};
  const Binding march[] = {{0, &entry.targets->march_radiance}};
  gather_.run({0, 0, panorama_size.width, rows}, target, march);
  entry.panorama->clouds.make_levels();
  entry.targets.reset();
}

// In whatever light, from wherever.
bool WaterStage::is_of_clouds(const Entry& entry, const Cloudscape& sky) {
  return entry.cloudscape->volume == sky.volume && entry.cloudscape->shape == sky.shape;
}

std::shared_ptr<const CloudPanorama> WaterStage::newest_like(const Entry& entry) const {
  for (const Entry& other : entries_)
    if (!other.targets && is_of_clouds(other, *entry.cloudscape)) return other.panorama;
  return nullptr;
}

bool WaterStage::prepare(const Scene& scene, WaterView& view) {
  const Cloudscape& sky = *scene.request.cloudscape;
  if (!has_water(sky) || (view.sky && (view.panorama || !has_clouds(scene.cloud)))) return true;
  if (!view.sky) {
    FrameRequest above = scene.request;
    above.pose.position_m.z = *sky.ground.water.level_m + eye_above_m;
    const FrameBlock frame = frame_block(above, 0);
    frame_block_.upload(frame), frame_block_.bind();
    cloud_block_.upload(scene.cloud), cloud_block_.bind();
    view.sky = scene.sky.get(frame, scene.cloud, AltitudeOfView::exact, sky_lag(scene.request, scene.sky_rests));
  }
  if (!has_clouds(scene.cloud)) return true;
  Entry& entry = entry_of(scene);
  const bool rests = scene.clouds_rest && newest_like(entry);
  if (entry.targets && !rests) render_slice(scene, *view.sky, entry);
  if (!entry.targets)
    view.panorama = entry.panorama;
  else if (scene.request.light_may_lag)
    view.panorama = newest_like(entry);
  return view.panorama != nullptr;
}

std::vector<Binding> WaterStage::bind(const FrameRequest& request, const WaterView& view) {
  if (!view.sky) return {};
  WaterBlock block = water_block(request);
  std::vector<Binding> textures{{0, &view.sky->view->even}, {1, &view.sky->view->aerosol}};
  if (view.panorama) {
    const glm::dvec2 at_m = view.panorama->eye_m + drift_of_clouds(request) - glm::dvec2(request.pose.position_m);
    block.clouds = {at_m.x, at_m.y, view.panorama->altitude_m, levels - 1};
    textures.push_back({2, &view.panorama->clouds});
  }
  block_.upload(block);
  block_.bind();
  return textures;
}

void WaterStage::reload(gpu::ShaderLibrary& shaders) {
  gather_.reload(shaders);
  entries_.clear();
}

}  // namespace cloudscape::render
