// The renderer's pictures that are path-traced.
#include "core/milliseconds.h"
#include "render/renderer.h"

namespace cloudscape::render {

using Clock = std::chrono::steady_clock;

// A slice of a path-traced picture.
bool Renderer::advance_trace(RenderJob& job) {
  const auto start = Clock::now();
  if (!job.trace) {
    std::optional<bake::PhaseTable> table;
    if (job.phase && !(table = bakes_.phases().table_of(phase_recipe(job.request.cloudscape->medium.phase))))
      return false;
    job.timer.start();
    job.trace = tracer_.begin(job.request, *job.baked, table);
  }
  job.passes.start();
  const SkyTables::Set sky = bind_blocks(job, 0);
  TracedScene scene{terrain_.bind(job.request, job.land), job.land.terrain != nullptr};
  scene.textures.insert(scene.textures.end(), {{0, &job.baked->shape()},
                                               {1, &job.baked->detail()},
                                               {2, &job.baked->variation()},
                                               {7, &sky.view->aerosol},
                                               {8, &sky.air->transmittance},
                                               {9, &sky.view->even},
                                               {10, &sky.lights->light},
                                               {14, &sky.view->aerial}});
  const bool done = tracer_.advance(*job.trace, scene);
  if (done) finish_trace(job);
  job.passes.lap("trace");
  job.render_ms += ms_since(start);
  return done;
}

void Renderer::finish_trace(RenderJob& job) {
  History& history = history_of(job.request);
  job.standard_error =
      gpu::Texture(gpu::Format::rgba32f, job.request.size_px.width, job.request.size_px.height, "standard error");
  tracer_.resolve(*job.trace, history.accumulation, job.standard_error);
  history.samples = job.trace->stand.samples;
  job.targets = pool_.acquire(job.request.size_px, job.request.quality);
  job.timer.stop();
}

}  // namespace cloudscape::render
