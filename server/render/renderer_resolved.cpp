// Frames of moving pictures: what is left to do when their rays are marched.
#include "core/milliseconds.h"
#include "render/discs.h"
#include "render/renderer.h"

namespace cloudscape::render {

// What is seen for the first time (beyond the edges when the picture turns, and behind land that moves), and sun and
// moon.
void Renderer::march_newly_seen(RenderJob& job) {
  const FrameRequest request = newly_seen_request(job.resolved->asked, job.resolved->plan);
  FrameBlock frame = frame_block(request, job.sample);
  frame.lens.z = frame.lens.w = 0;
  frame.accumulation.x = 1;
  widen_discs(frame, request.size_px, request.lens.vertical_fov_deg);
  frame.march_target.z = 1;
  frame_block_.upload(frame);
  auto targets = pool_.acquire(request.size_px, request.quality);
  targets->scene_depth.clear();
  passes_.march_newly(*targets, *job.sky, medium_and_scene_of(job), resolver_.newly_seen(*job.resolved), job.passes);
  resolver_.add_newly_seen(*job.resolved, *targets, job.passes);
  pool_.release(std::move(targets));
}

PendingFrame Renderer::finish_resolved(std::unique_ptr<RenderJob> job) {
  const auto start = std::chrono::steady_clock::now();
  frame_block_.upload(frame_block(job->resolved->asked, 0));
  frame_block_.bind();
  job->passes.start();
  PendingFrame pending;
  pending.samples = 1;
  pending.display = gpu::Readback(resolver_.present(*job->resolved, passes_.bloom(), job->passes), readbacks_);
  pending.enlargement = enlargement_of(job->resolved->plan);
  job->passes.lap("read_back");
  context_.flush();
  pending.request = std::move(job->resolved->asked);
  pending.timings.render_ms = job->render_ms + ms_since(start);
  pending.timer = std::move(job->timer);
  pending.passes = std::move(job->passes);
  pool_.release(std::move(job->targets));
  return pending;
}

}  // namespace cloudscape::render
