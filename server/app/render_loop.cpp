#include "app/render_loop.h"

#include <algorithm>

#include "app/frame_pump.h"

namespace cloudscape::app {
namespace {

using Clock = std::chrono::steady_clock;

// tuned: how often the loop looks after shaders on disk and streams that have gone; each look takes microseconds.
constexpr auto look_after = std::chrono::milliseconds(250);

FrameRequest first_request(const std::shared_ptr<const Cloudscape>& cloudscape) {
  FrameRequest request;
  request.cloudscape = cloudscape;
  request.pose = cloudscape->view.pose;
  request.size_px = {64, 36};
  request.quality = render_quality(Quality::draft);
  return request;
}

FramePump::Sink sink_of(net::Server& server) {
  return {net::Server::frame_front(),
          [&server](const stream::Work& work, const FrameTimings& timings, EncodedFrame image) {
            if (work.still) return server.deliver_still(work.request.stream, std::move(image));
            server.deliver_frame(work, timings, std::move(image));
          },
          [&server](StreamId stream, const std::string& message, int status) { server.fail(stream, message, status); },
          [&server](StreamId stream, double share, int samples) { server.tell_samples(stream, share, samples); }};
}

}  // namespace

RenderLoop::RenderLoop(GpuOptions options, std::shared_ptr<const Cloudscape> first, stream::FrameScheduler& scheduler,
                       net::Server& server, Metrics& metrics, std::function<void()> on_ready)
    : options_(std::move(options)),
      first_(std::move(first)),
      scheduler_(scheduler),
      server_(server),
      metrics_(metrics),
      on_ready_(std::move(on_ready)),
      thread_([this] { run(); }) {}

RenderLoop::~RenderLoop() { thread_.join(); }

std::exception_ptr RenderLoop::failure() const { return failed_ ? failure_ : nullptr; }

void RenderLoop::run() {
  try {
    GpuStack stack(options_, progress_on_stderr());
    start(stack);
    loop(stack);
  } catch (...) {
    failure_ = std::current_exception();
    failed_ = true;
    server_.request_stop();
  }
}

// The first picture compiles the shaders and shows that the device renders; only then is the server ready.
void RenderLoop::start(GpuStack& stack) {
  stack.renderer.render(first_request(first_));
  stack.renderer.forget(0);
  const gpu::DeviceInfo& device = stack.context.device();
  server_.set_ready({device.renderer, device.vendor, device.gl_version,
                     stack.context.execution() == gpu::PassExecution::compute ? "compute" : "fragment",
                     device.software});
  if (!scheduler_.stopped()) on_ready_();
}

void RenderLoop::loop(GpuStack& stack) {
  FramePump pump(scheduler_, stack.renderer, sink_of(server_));
  for (auto looked = Clock::now();;) {
    const bool worked = pump.step(Clock::now() + look_after);
    if (!worked && scheduler_.stopped()) return;
    if (worked && Clock::now() - looked < look_after) continue;
    looked = Clock::now();
    pump.drop_the_gone();
    if (stack.shaders.changed()) stack.renderer.reload_shaders();
    tell_memory(stack);
  }
}

// What is kept for viewers and stills from frame to frame: of all, and of the one that has most. Limits of size and
// number bound both (README, "Limits").
void RenderLoop::tell_memory(const GpuStack& stack) {
  std::size_t largest = 0;
  for (const StreamId stream : stack.renderer.remembered())
    largest = std::max(largest, stack.renderer.history_bytes(stream));
  metrics_.set("cloudscape_history_bytes", static_cast<double>(stack.renderer.history_bytes()));
  metrics_.set("cloudscape_history_largest_bytes", static_cast<double>(largest));
  metrics_.set("cloudscape_bake_bytes", static_cast<double>(stack.bakes.bytes()));
}

}  // namespace cloudscape::app
