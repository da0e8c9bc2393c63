#include "render/path_tracer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "render/block_values.h"

namespace cloudscape::render {
namespace {

using Clock = std::chrono::steady_clock;
using gpu::Binding, gpu::Format, gpu::Texture;

constexpr double slice_ms = 50;  // tuned: as a marched frame's slices
// tuned: so many that the state is seldom loaded and stored, so few that a slice stays short.
constexpr int rounds = 16, flights = 8;
constexpr int most_slots = 1 << 18;         // tuned: enough to fill a large GPU; 38 MB
constexpr std::size_t slot_bytes = 144;     // shaders/trace/state.glsl
constexpr std::size_t air_slot_bytes = 32;  // shaders/trace/air_traced.glsl
constexpr const char* pass_paths[] = {"trace/paths.comp", "trace/paths_terrain.comp", "trace/paths_air.comp",
                                      "trace/paths_terrain_air.comp"};
// Altitude along a ray changes faster than at its beginning by at most its length over the planet's radius, and no ray
// asks further than 2 km ahead (shaders/trace/bounds.glsl).
constexpr double most_bend = 2e-4;

struct Counters {
  std::uint32_t next_pixel = 0, listed = 0, samples = 0, flights = 0, above_majorant = 0;
};

template <class T>
std::span<const std::byte> bytes_of(const T& value) {
  return std::as_bytes(std::span(&value, 1));
}

Texture sum_texture(ImageSize size) {
  Texture texture(Format::rgba32f, size.width, size.height, "path tracer's sums");
  texture.clear();
  return texture;
}

std::vector<float> floats_of(const Texture& texture) {
  const std::vector<std::uint8_t> bytes = texture.download();
  const auto* first = reinterpret_cast<const float*>(bytes.data());
  return {first, first + bytes.size() / sizeof(float)};
}

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

int mean_samples(const Trace& trace) {
  const auto pixels =
      static_cast<std::uint64_t>(trace.size_px.width) * static_cast<std::uint64_t>(trace.size_px.height);
  return static_cast<int>(trace.counts.samples / pixels);
}

double share_done(const Trace& trace) {
  double share = static_cast<double>(mean_samples(trace)) / trace.goal.samples;
  if (trace.goal.time_budget_s) share = std::max(share, trace.stand.seconds / *trace.goal.time_budget_s);
  if (trace.goal.noise_target && trace.stand.relative_error > 0)
    share = std::max(share, std::pow(*trace.goal.noise_target / trace.stand.relative_error, 2));
  return std::min(share, 1.0);
}

PathTracer::PathTracer(const gpu::Context& context, gpu::ShaderLibrary& shaders)
    : context_(context),
      shaders_(shaders),
      majorants_(shaders),
      resolve_(context, shaders, "trace/resolve.glsl", {Format::rgba32f, Format::r32f, Format::rgba32f}),
      block_("path tracer") {}

std::unique_ptr<Trace> PathTracer::begin(const FrameRequest& request, const bake::BakedCloudscape& baked,
                                         const std::optional<bake::PhaseTable>& phase) {
  auto trace = std::make_unique<Trace>();
  const Tracing& tracing = request.tracing;
  trace->size_px = request.size_px;
  trace->goal = {std::max(1, request.quality.samples), tracing.time_budget_s, tracing.noise_target};
  trace->seed = tracing.seed;
  trace->max_order = tracing.max_scattering_order.value_or(0);
  const std::int64_t pixels = std::int64_t{request.size_px.width} * request.size_px.height;
  trace->slot_count = static_cast<int>(std::min<std::int64_t>(pixels, most_slots));
  const auto slots = static_cast<std::size_t>(trace->slot_count);
  trace->slots = gpu::StorageBuffer(slots * slot_bytes, "paths");
  trace->traced_air = tracing.atmosphere == TracedAtmosphere::traced;
  if (trace->traced_air) trace->air_slots = gpu::StorageBuffer(slots * air_slot_bytes, "paths in the air");
  for (auto& list : trace->lists) list = gpu::StorageBuffer(slots * sizeof(std::uint32_t), "list of paths");
  trace->counters = gpu::StorageBuffer(sizeof(Counters), "path tracer's counters");
  for (Texture& sum : trace->sums) sum = sum_texture(request.size_px);
  if (phase) trace->phase = bake::phase_sampling(*phase);
  const Cloudscape sky = *as_marched(request, baked).cloudscape;
  const bool layer = sky.volume.kind == VolumeKind::noise;
  if (!layer && !is_from_file(sky.volume.kind)) return trace;
  trace->majorants = majorants_.build(baked, mixing_weights(sky));
  const auto& fine = trace->majorants.fine;
  trace->cells = {fine.width(), fine.height(), fine.depth(), bake::majorant_block};
  const LandSlopes slopes = land_slopes(sky, baked);
  trace->slopes = {slopes.shift_per_m, slopes.shift_per_m, slopes.threshold_per_m,
                   layer ? most_bend / sky.volume.size_m.z : 0.0};
  return trace;
}

const gpu::StoragePass& PathTracer::pass_for(const Trace& trace, const TracedScene& scene) {
  const std::size_t kind = (scene.terrain ? 1U : 0U) + (trace.traced_air ? 2U : 0U);
  auto& pass = passes_[kind];
  if (!pass) pass.emplace(shaders_, pass_paths[kind]);
  return *pass;
}

void PathTracer::begin_wave(Trace& trace, int samples) {
  trace.wave_end = trace.stand.samples + samples;
  trace.listed = trace.slot_count, trace.next_entry = 0;
  std::vector<std::uint32_t> all(static_cast<std::size_t>(trace.slot_count));
  std::iota(all.begin(), all.end(), 0U);
  trace.lists[trace.list].upload(std::as_bytes(std::span(all)));
  trace.counters.upload(bytes_of(Counters{}));
}

bool PathTracer::advance(Trace& trace, const TracedScene& scene) {
  pass_for(trace, scene);  // whose compilation is not rendering
  const auto start = Clock::now();
  if (trace.listed == 0) {
    const int samples = next_wave(trace.goal, trace.stand);
    if (samples == 0) return true;
    begin_wave(trace, samples);
  }
  // A GPU ends a dispatch before the next slice's time is over: many make a slice.
  do {
    dispatch(trace, scene);
    if (trace.next_entry >= trace.listed) end_sweep(trace);
  } while (trace.listed > 0 && !context_.device().software && 1000 * seconds_since(start) < slice_ms);
  trace.stand.seconds += seconds_since(start);
  if (trace.listed > 0) return false;
  trace.stand.samples = trace.wave_end;
  if (trace.noise_wanted()) trace.stand.relative_error = relative_error(trace);
  return next_wave(trace.goal, trace.stand) == 0;
}

// Of the list, as many entries as a slice has time for.
void PathTracer::dispatch(Trace& trace, const TracedScene& scene) {
  const auto start = Clock::now();
  const int wanted = context_.device().software ? static_cast<int>(slice_ms * entries_per_ms_) : trace.slot_count;
  const int entries =
      std::min({std::max(wanted, gpu::StoragePass::group), most_entries_, trace.listed - trace.next_entry});
  const int pixels = trace.size_px.width * trace.size_px.height;
  TraceBlock block;
  block.work = {trace.next_entry, entries, pixels, trace.wave_end};
  block.limits = {trace.max_order, rounds, flights, trace.slot_count};
  block.seed = {trace.seed, static_cast<unsigned>(trace.stand.samples), 0, 0};
  block.cells = trace.cells, block.slopes = trace.slopes;
  block_.upload(block);
  block_.bind();
  trace.slots.bind(0);
  trace.lists[trace.list].bind(1);
  trace.lists[1 - trace.list].bind(2);
  trace.counters.bind(3);
  if (trace.traced_air) trace.air_slots.bind(4);
  std::vector<Binding> textures = scene.textures;
  if (trace.majorants.fine)
    textures.insert(textures.end(), {{6, &trace.majorants.fine}, {15, &trace.majorants.coarse}});
  if (trace.phase) textures.insert(textures.end(), {{5, &trace.phase->texels}, {3, &trace.phase->aliases}});
  const Texture* images[] = {&trace.sums[0], &trace.sums[1], &trace.sums[2], &trace.sums[3]};
  pass_for(trace, scene).run(entries, textures, images);
  trace.next_entry += entries;
  if (!context_.device().software) return;
  context_.finish();
  entries_per_ms_ = std::lerp(entries_per_ms_, entries / std::max(0.1, 1000 * seconds_since(start)), 0.3);
}

// Every path of the list has gone on; those that are not done are in the other list.
void PathTracer::end_sweep(Trace& trace) {
  Counters counters;
  trace.counters.download(std::as_writable_bytes(std::span(&counters, 1)));
  trace.counts.samples += counters.samples;
  trace.counts.flights += counters.flights;
  trace.counts.above_majorant += counters.above_majorant;
  trace.listed = static_cast<int>(counters.listed);
  trace.list = 1 - trace.list;
  trace.next_entry = 0;
  trace.counters.upload(bytes_of(Counters{.next_pixel = counters.next_pixel}));
}

double PathTracer::relative_error(const Trace& trace) {
  const Accumulation mean = make_accumulation(trace.size_px);
  const Texture standard_error(Format::rgba32f, trace.size_px.width, trace.size_px.height, "standard error");
  resolve(trace, mean, standard_error);
  const std::vector<float> radiance = floats_of(mean.radiance), error = floats_of(standard_error);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    if (i % 4 == 3) continue;
    sum += radiance[i];
    squares += double{error[i]} * error[i];
  }
  const double values = 0.75 * static_cast<double>(radiance.size());
  return sum > 0 ? std::sqrt(squares / values) / (sum / values) : 0;
}

void PathTracer::resolve(const Trace& trace, const Accumulation& target, const Texture& standard_error) {
  TraceBlock block{};
  block.work.w = trace.stand.samples;
  block_.upload(block);
  block_.bind();
  const Binding sums[] = {{0, &trace.sums[0]}, {1, &trace.sums[1]}, {2, &trace.sums[2]}, {3, &trace.sums[3]}};
  const Texture* targets[] = {&target.radiance, &target.depth, &standard_error};
  resolve_.run({0, 0, trace.size_px.width, trace.size_px.height}, targets, sums);
}

void PathTracer::reload() {
  resolve_.reload(shaders_);
  for (auto& pass : passes_)
    if (pass) pass->reload(shaders_);
}

}  // namespace cloudscape::render
