#include "render/renderer.h"

#include <algorithm>
#include <cmath>

#include "core/enlarge.h"
#include "core/march_steps.h"
#include "core/milliseconds.h"
#include "core/sun_position.h"
#include "render/block_values.h"

namespace cloudscape::render {
namespace {

using Clock = std::chrono::steady_clock;

// tuned: a slice on a software rasterizer; short enough that another viewer's frame is not late, long enough to keep
// both cores busy. A GPU takes slices by their work instead, since waiting for each would leave it idle.
constexpr double slice_ms = 60;
constexpr double gpu_steps_per_slice = 2e9;

// Red, green, blue of texels of four.
void drop_every_fourth(std::vector<float>& values) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (i % 4 != 3) values[kept++] = values[i];
  values.resize(kept);
}

}  // namespace

bake::PhaseRecipe Renderer::phase_recipe(const Phase& phase) {
  return {.effective_radius_um = phase.effective_radius_um, .effective_variance = phase.effective_variance};
}

bool PendingFrame::ready() const {
  return (!display || display.ready()) && (!radiance || radiance.ready()) && (!depth || depth.ready()) &&
         (!standard_error || standard_error.ready());
}

Renderer::Renderer(const gpu::Context& context, gpu::ShaderLibrary& shaders, bake::BakeStore& bakes,
                   std::filesystem::path height_maps)
    : context_(context),
      shaders_(shaders),
      bakes_(bakes),
      structures_(shaders),
      distances_(shaders, context.device().software ? 64 : 128, bakes.files()),
      passes_(context, shaders),
      sky_(context, shaders),
      in_scatter_(shaders, bake::LightCache(bakes.files())),
      densities_(shaders),
      sun_depths_(shaders, densities_),
      ambient_(shaders, densities_),
      terrain_(context, shaders, std::move(height_maps), bakes.files()),
      resolver_(context, shaders),
      water_(context, shaders),
      tracer_(context, shaders),
      frame_block_("frame"),
      cloud_block_("cloud") {}

Renderer::History& Renderer::history_of(const FrameRequest& request) {
  History& history = histories_[request.stream];
  if (!history.accumulation.radiance || !(history.size == request.size_px))
    history = {make_accumulation(request.size_px), request.size_px, 0};
  return history;
}

std::unique_ptr<RenderJob> Renderer::begin(const FrameRequest& request) {
  auto job = std::make_unique<RenderJob>();
  job->request = request;
  if (request.time_passes) job->passes = PassClock(context_);
  job->request.cloudscape = at_time(request.cloudscape, request.time_s);
  if (continues_picture(request)) {
    job->resolved = resolver_.begin(job->request);
    job->request = marched_request(job->request, job->resolved->plan);
    job->sample = job->last_sample = marched_sample(job->resolved->plan, job->resolved->frame);
    if (request.light_may_lag)
      job->turn = static_cast<LaggingTurn>(job->resolved->frame % (has_water(*job->request.cloudscape) ? 4 : 2));
    return job;
  }
  resolver_.outdate(request);
  const History& history = history_of(request);
  job->sample = request.first_sample == history.samples ? request.first_sample : 0;
  job->last_sample = job->sample + std::max(1, request.quality.samples) - 1;
  return job;
}

bool Renderer::advance(RenderJob& job) {
  const auto start = Clock::now();
  const bool has_land = terrain_.prepare(job.request, job.land);  // the clouds are prepared beside it
  if (!has_land) context_.finish();
  if (!find_baked(job)) return false;
  if (job.request.quality.technique == Technique::path_tracing) return has_land && advance_trace(job);
  if (!find_distances(job) || !find_in_scatter(job) || !find_sun_depth(job) || !find_water(job) || !has_land)
    return false;
  if (!job.targets) {
    const bool by_tiles = job.resolved && context_.device().software;
    const RayPlaces places = by_tiles ? RayPlaces::over_tiles : RayPlaces::first;
    job.targets = pool_.acquire(job.request.size_px, job.request.quality, places);
    job.timer.start();
  }
  render_rows(job);
  if (job.row >= job.targets->march_size.height) finish_sample(job);
  const bool done = job.sample > job.last_sample;
  if (done) job.timer.stop();
  job.render_ms += ms_since(start);
  return done;
}

// All that is computed before the first frame of a cloudscape; else computes a slice of it.
bool Renderer::find_baked(RenderJob& job) {
  const Cloudscape& sky = *job.request.cloudscape;
  if (!job.baked) {
    const bake::BakeRecipe recipe = bakes_.recipe_of(sky);
    job.baked = bakes_.find(recipe);
    if (!job.baked) {
      bakes_.advance(recipe);
      context_.finish();
      return false;
    }
  }
  const Phase& phase = sky.medium.phase;
  if (job.phase || phase.kind != PhaseKind::mie) return true;
  job.phase = bakes_.phases().find(phase_recipe(phase), sky.sun.angular_radius_deg);
  return job.phase != nullptr;
}

// The light in the clouds, where the document's model solves it before the march.
bool Renderer::find_in_scatter(RenderJob& job) {
  const Cloudscape& sky = *job.request.cloudscape;
  if (job.in_scatter || sky.medium.light_model.kind != LightModelKind::in_scatter_volume) return true;
  const SkyTables::Set& tables = bind_blocks(job, job.sample);
  const double g = mean_cosine(sky.medium.phase, job.phase ? job.phase->mean_asymmetry_g : 0);
  job.in_scatter = in_scatter_.find({job.request, job.baked, tables.lights, g, job.rests(LaggingTurn::sky)});
  if (!job.in_scatter) context_.finish();
  return job.in_scatter != nullptr;
}

// The clouds' shadows, and what they let through of sky and ground.
bool Renderer::find_sun_depth(RenderJob& job) {
  if (job.sun_depth && (job.ambient || !has_ambient_visibility(*job.request.cloudscape))) return true;
  const CloudBlock cloud = cloud_values(job);
  const CloudDensities::Wanted wanted{job.request, cloud, job.baked, job.rests(LaggingTurn::shadows)};
  if (sun_depths_.prepare(wanted, job.sun_depth) && ambient_.prepare(wanted, job.ambient)) return true;
  context_.finish();
  return false;
}

// How far from clouds each place is.
bool Renderer::find_distances(RenderJob& job) {
  if (job.distances || !job.request.march.distance_field || !is_textured(job.request.cloudscape->volume.kind))
    return true;
  const bake::DistancePlan plan = distance_plan_of(*as_marched(job.request, *job.baked).cloudscape, *job.baked);
  if (distances_.advance(job.baked, plan)) {
    job.distances = plan;
    return true;
  }
  context_.finish();
  return false;
}

// The clouds without land and water.
Passes::Medium Renderer::medium_of(const RenderJob& job) {
  const bool distances = job.request.march.distance_field;
  const gpu::Texture* nearness = &job.baked->shape();  // formulas have none
  if (job.distances)
    nearness = &distances_.of(*job.baked, *job.distances);
  else if (is_textured(job.request.cloudscape->volume.kind))
    nearness = &structures_.of(*job.baked, mixing_weights(*as_marched(job.request, *job.baked).cloudscape));
  const gpu::Texture* phase = job.phase ? &job.phase->texture : nullptr;
  Passes::Medium medium{*job.baked,           *nearness,           distances,        {}, phase,
                        job.in_scatter.get(), job.sun_depth.get(), job.ambient.get()};
  medium.kinds = march_kinds(cloud_values(job), job.request.cloudscape->sky.kind);
  return medium;
}

// With them, whose blocks it binds.
Passes::Medium Renderer::medium_and_scene_of(const RenderJob& job) {
  Passes::Medium medium = medium_of(job);
  medium.scene = scene_kind_of(*job.request.cloudscape);
  medium.land = terrain_.bind(job.request, job.land);
  std::ranges::copy(water_.bind(job.request, job.water), std::back_inserter(medium.land));
  return medium;
}

// What water reflects.
bool Renderer::find_water(RenderJob& job) {
  if (!has_water(*job.request.cloudscape)) return true;
  const CloudBlock cloud = cloud_values(job);
  const bool found = water_.prepare({job.request, cloud, medium_of(job), job.in_scatter, job.sun_depth, passes_, sky_,
                                     job.rests(LaggingTurn::water_sky), job.rests(LaggingTurn::clouds_in_water)},
                                    job.water);
  if (!found) context_.finish();
  return found;
}

int Renderer::rows_of_next_slice(const RenderJob& job) const {
  const int width = job.targets->march_size.width;
  const MarchSteps steps = march_steps(job.request.march, job.request.quality);
  const double pixels =
      context_.device().software ? slice_ms * pixels_per_ms_ : gpu_steps_per_slice / std::max(1, steps.view);
  return std::max(1, static_cast<int>(pixels / width));
}

CloudBlock Renderer::cloud_values(const RenderJob& job) const {
  CloudBlock cloud = cloud_block(job.request, *job.baked);
  if (job.phase) cloud.phase.x = static_cast<float>(job.phase->mean_asymmetry_g);
  set_mean_cosine(cloud, mean_cosine(job.request.cloudscape->medium.phase, cloud.phase.x));
  return cloud;
}

// The blocks of a sample, which others may have used in between, and the tables of its sky.
const SkyTables::Set& Renderer::bind_blocks(RenderJob& job, int sample) {
  FrameBlock frame = frame_block(job.request, sample);
  if (job.resolved) {
    const glm::dvec2 offset = marched_offset(job.resolved->plan, job.resolved->frame, job.resolved->resting);
    frame.lens.z = static_cast<float>(offset.x), frame.lens.w = static_cast<float>(offset.y);
    frame.accumulation.x = 1;  // each is a picture of its own
    if (job.targets) frame.march_target = {job.targets->march_origin.x, job.targets->march_origin.y, 0, 0};
  }
  const CloudBlock cloud = cloud_values(job);
  frame_block_.upload(frame);
  cloud_block_.upload(cloud);
  frame_block_.bind();
  cloud_block_.bind();
  const AltitudeOfView altitude = job.resolved ? AltitudeOfView::by_sixteenths : AltitudeOfView::exact;
  if (!job.sky) job.sky = sky_.get(frame, cloud, altitude, sky_lag(job.request, job.rests(LaggingTurn::sky)));
  return *job.sky;
}

void Renderer::render_rows(RenderJob& job) {
  const auto start = Clock::now();
  job.passes.start();
  const SkyTables::Set& sky = bind_blocks(job, job.sample);
  job.passes.lap("sky");
  const int end = std::min(job.row + rows_of_next_slice(job), job.targets->march_size.height);
  passes_.march(*job.targets, sky, medium_and_scene_of(job), job.row, end, job.passes);
  const double pixels = static_cast<double>(end - job.row) * job.targets->march_size.width;
  job.row = end;
  if (!context_.device().software) return context_.flush();
  context_.finish();
  pixels_per_ms_ = std::lerp(pixels_per_ms_, pixels / std::max(0.1, ms_since(start)), 0.3);
}

void Renderer::finish_sample(RenderJob& job) {
  if (job.resolved) {
    passes_.composite(*job.targets, Accumulation{}, job.passes);
    if (resolver_.resolve(*job.resolved, job.targets->scratch, job.passes)) march_newly_seen(job);
    ++job.sample;
    return;
  }
  History& history = history_of(job.request);
  passes_.composite(*job.targets, history.accumulation, job.passes);
  std::swap(history.accumulation, job.targets->scratch);
  history.samples = ++job.sample;
  job.row = 0;
}

PendingFrame Renderer::finish(std::unique_ptr<RenderJob> job) {
  const auto start = Clock::now();
  PendingFrame pending;
  if (job->resolved) return finish_resolved(std::move(job));
  job->passes.start();
  const History& history = history_of(job->request);
  pending.samples = history.samples;
  if (job->request.content == FrameContent::display) {
    frame_block_.upload(frame_block(job->request, job->last_sample));  // other jobs may have been at work in between
    frame_block_.bind();
    prepare_bloom(*job->targets, job->request);
    passes_.tone_map(*job->targets, history.accumulation, job->passes);
    pending.display = gpu::Readback(job->targets->display, readbacks_);
  } else {
    pending.radiance = gpu::Readback(history.accumulation.radiance);
    pending.depth = gpu::Readback(history.accumulation.depth);
    if (job->standard_error) pending.standard_error = gpu::Readback(job->standard_error);
  }
  job->passes.lap("read_back");
  context_.flush();
  pending.request = std::move(job->request);
  pending.timings.render_ms = job->render_ms + ms_since(start);
  pending.timer = std::move(job->timer);
  pending.passes = std::move(job->passes);
  pool_.release(std::move(job->targets));
  return pending;
}

Frame Renderer::collect(PendingFrame pending) const {
  const auto start = Clock::now();
  const auto floats_of = [](const std::vector<std::uint8_t>& bytes) {
    const auto* first = reinterpret_cast<const float*>(bytes.data());
    return std::vector<float>(first, first + bytes.size() / sizeof(float));
  };
  Frame frame;
  frame.samples = pending.samples;
  frame.enlargement = pending.enlargement;
  frame.timings = pending.timings;
  if (pending.display) frame.display_rgba = pending.display.take();
  if (pending.radiance) {
    frame.radiance_rgba = floats_of(pending.radiance.take());
    frame.depth_m = floats_of(pending.depth.take());
    constexpr float farthest_m = 1e7F;  // beyond every horizon: sky, or an average with sky in it
    for (float& depth_m : frame.depth_m)
      if (depth_m > farthest_m) depth_m = std::numeric_limits<float>::infinity();
  }
  if (pending.standard_error) {
    frame.standard_error_rgb = floats_of(pending.standard_error.take());
    drop_every_fourth(frame.standard_error_rgb);
  }
  frame.timings.gpu_ms = pending.timer.milliseconds();
  frame.timings.passes = pending.passes.times();
  frame.timings.readback_ms = ms_since(start);
  frame.request = std::move(pending.request);
  return frame;
}

Frame Renderer::render(const FrameRequest& request) {
  auto job = begin(request);
  while (!advance(*job)) {
  }
  Frame frame = collect(finish(std::move(job)));
  enlarge(frame);
  return frame;
}

void Renderer::abandon(std::unique_ptr<RenderJob> job) {
  if (job->targets) pool_.release(std::move(job->targets));
}

void Renderer::forget(StreamId stream) {
  histories_.erase(stream);
  resolver_.forget(stream);
}

std::vector<StreamId> Renderer::remembered() const {
  std::vector<StreamId> streams = resolver_.remembered();
  for (const auto& [stream, history] : histories_) streams.push_back(stream);
  return streams;
}

void Renderer::reload_shaders() {
  passes_.reload(shaders_);
  sky_.reload(shaders_);
  in_scatter_.reload(shaders_);
  densities_.reload(shaders_);
  sun_depths_.reload(shaders_);
  ambient_.reload(shaders_);
  terrain_.reload(shaders_);
  resolver_.reload(shaders_);
  water_.reload(shaders_);
  tracer_.reload();
}

std::size_t Renderer::history_bytes() const {
  std::size_t sum = resolver_.bytes();
  for (const auto& [stream, history] : histories_) sum += history.accumulation.bytes();
  return sum;
}

std::size_t Renderer::history_bytes(StreamId stream) const {
  const auto found = histories_.find(stream);
  return resolver_.bytes_of(stream) + (found == histories_.end() ? 0 : found->second.accumulation.bytes());
}

}  // namespace cloudscape::render
