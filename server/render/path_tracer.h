// The reference renderer: an unbiased volumetric path tracer (shaders/trace). It renders in slices of some tens of
// milliseconds, between which other frames may go; each path keeps its state on the device, so that none is cut short.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "bake/majorants.h"
#include "bake/phase_sampling.h"
#include "core/frame.h"
#include "gpu/context.h"
#include "gpu/storage.h"
#include "render/blocks.h"
#include "render/targets.h"
#include "render/trace_plan.h"

namespace cloudscape::render {

// What was done so far, for progress and measurement.
struct TraceCounts {
  std::uint64_t samples = 0;  // of all pixels
  std::uint64_t flights =
      0;  // of paths and of rays towards the sun, from one place where something is decided to the next
  std::uint64_t above_majorant = 0;  // densities that exceeded their bound: must be 0
};

// A picture that is being traced: paths, sums, and where they are.
struct Trace {
  gpu::StorageBuffer slots, lists[2], counters;
  gpu::StorageBuffer air_slots;      // where the atmosphere is traced
  std::array<gpu::Texture, 4> sums;  // shaders/trace/sums.glsl
  bake::Majorants majorants;
  std::optional<bake::PhaseSampling> phase;
  TraceGoal goal;
  TraceStand stand;
  TraceCounts counts;
  ImageSize size_px;
  std::uint32_t seed = 1;
  int max_order = 0;  // 0: none
  int slot_count = 0;
  bool traced_air = false;
  int wave_end = 0;  // sample that none may begin in the current wave
  int listed = 0, next_entry = 0, list = 0;
  vec4 slopes{0};  // TraceBlock
  ivec4 cells{1};
  bool noise_wanted() const { return goal.noise_target.has_value(); }
};

// 0..1 of the work, as far as it can be told: a time budget or a noise target may end it sooner.
double share_done(const Trace& trace);
// Samples that each pixel has, on average.
int mean_samples(const Trace& trace);

// Textures that a slice reads, bound as shaders/render has them; blocks of frame, cloud and terrain must be bound.
struct TracedScene {
  std::vector<gpu::Binding> textures;
  bool terrain = false;
};

class PathTracer {
 public:
  PathTracer(const gpu::Context& context, gpu::ShaderLibrary& shaders);
  // `phase`: the table of a phase function that is looked up.
  std::unique_ptr<Trace> begin(const FrameRequest& request, const bake::BakedCloudscape& baked,
                               const std::optional<bake::PhaseTable>& phase);
  bool advance(Trace& trace, const TracedScene& scene);  // renders the next slice; true when all is rendered
  // The mean so far into `target`, and its standard error (rgba32f). Only between waves: when `advance` was true.
  void resolve(const Trace& trace, const Accumulation& target, const gpu::Texture& standard_error);
  void reload();
  // No more paths a slice than this; it changes no pixel.
  void limit_slices(int paths) { most_entries_ = paths; }

 private:
  const gpu::StoragePass& pass_for(const Trace& trace, const TracedScene& scene);
  void begin_wave(Trace& trace, int samples);
  void end_sweep(Trace& trace);
  double relative_error(const Trace& trace);
  void dispatch(Trace& trace, const TracedScene& scene);

  const gpu::Context& context_;
  gpu::ShaderLibrary& shaders_;
  bake::MajorantBuilder majorants_;
  gpu::ScreenPass resolve_;
  std::array<std::optional<gpu::StoragePass>, 4> passes_;  // as pass_paths; compiled when first used
  gpu::UniformBlock<TraceBlock> block_;
  int most_entries_ = 1 << 30;
  double entries_per_ms_ = 50;  // measured; it sizes the slices and changes no pixel
};

}  // namespace cloudscape::render
