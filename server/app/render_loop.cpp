#include "app/render_loop.h"

#include <algorithm>

#include "core/error.h"
#include "core/log.h"
#include "encode/encode.h"

namespace cloudscape::app {
namespace {

using Clock = std::chrono::steady_clock;

// tuned: how often the loop looks after shaders on disk and streams that have gone while nothing is to be rendered.
constexpr auto idle_wait = std::chrono::milliseconds(250);

// One core in four encodes; JPEG takes a twentieth of what a frame takes to render without a GPU.
unsigned encoder_threads() { return std::max(1U, std::thread::hardware_concurrency() / 4); }

FrameRequest first_request(const std::shared_ptr<const Cloudscape>& cloudscape) {
  FrameRequest request;
  request.cloudscape = cloudscape;
  request.pose = cloudscape->view.pose;
  request.size_px = {64, 36};
  request.quality = render_quality(Quality::draft);
  return request;
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
      encoders_(encoder_threads()),
      thread_([this] { run(); }) {}

RenderLoop::~RenderLoop() { thread_.join(); }

std::exception_ptr RenderLoop::failure() const { return failed_ ? failure_ : nullptr; }

void RenderLoop::run() {
  try {
    GpuStack stack(options_, progress_on_stderr());
    start(stack);
    loop(stack);
    pending_.reset();
    active_.clear();
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
  for (;;) {
    const auto work = scheduler_.take(pending_ ? Clock::now() : Clock::now() + idle_wait);
    if (work) advance(stack, *work);
    if (pending_ && (!work || pending_->frame.ready())) collect(stack);
    if (work) continue;
    if (scheduler_.stopped()) return;
    drop_the_gone(stack);
    if (stack.shaders.changed()) stack.renderer.reload_shaders();
    metrics_.set("cloudscape_history_bytes", static_cast<double>(stack.renderer.history_bytes()));
    metrics_.set("cloudscape_bake_bytes", static_cast<double>(stack.bakes.bytes()));
  }
}

// The unfinished job of this very work, or a new one.
RenderLoop::Active& RenderLoop::active_of(GpuStack& stack, const stream::Work& work) {
  Active& active = active_[work.request.stream];
  if (active.job && active.work.request.sequence == work.request.sequence && active.work.frame_id == work.frame_id)
    return active;
  if (active.job) stack.renderer.abandon(std::move(active.job));
  active = {work, stack.renderer.begin(work.request),
            std::chrono::duration<double, std::milli>(Clock::now() - work.queued).count()};
  return active;
}

void RenderLoop::advance(GpuStack& stack, const stream::Work& work) {
  try {
    Active& active = active_of(stack, work);
    if (!stack.renderer.advance(*active.job)) {
      tell_progress(active);
      if (!scheduler_.yield(work)) drop(stack, work.request.stream);
      return;
    }
    if (pending_) collect(stack);
    pending_ = Pending{work, stack.renderer.finish(std::move(active.job))};
    pending_->frame.timings.queue_ms = active.queue_ms;
    active_.erase(work.request.stream);
  } catch (const UnusableFile& error) {
    fail(stack, work, error.what(), 422);
  } catch (const std::exception& error) {
    fail(stack, work, error.what());
  }
}

void RenderLoop::tell_progress(Active& active) {
  constexpr auto pause = std::chrono::milliseconds(250);  // tuned: a bar that moves
  if (!active.job->trace || Clock::now() - active.told < pause) return;
  active.told = Clock::now();
  server_.tell_samples(active.work.request.stream, render::share_done(*active.job->trace),
                       render::mean_samples(*active.job->trace));
}

void RenderLoop::collect(GpuStack& stack) {
  Pending pending = std::move(*pending_);
  pending_.reset();
  try {
    Frame frame = stack.renderer.collect(std::move(pending.frame));
    if (pending.work.still) stack.renderer.forget(pending.work.request.stream);
    scheduler_.rendered(pending.work, frame.timings);
    encode(pending.work, std::move(frame));
  } catch (const std::exception& error) {
    fail(stack, pending.work, error.what());
  }
}

void RenderLoop::encode(const stream::Work& work, Frame frame) {
  encoders_.run([this, work, frame = std::make_shared<Frame>(std::move(frame))] {
    try {
      EncodedFrame image = encode::encode(*frame, work.encoding, work.still ? 0 : net::Server::frame_front());
      if (work.still) return server_.deliver_still(work.request.stream, std::move(image));
      scheduler_.encoded(work, image.bytes.size() - image.front, image.encode_ms);
      server_.deliver_frame(work, frame->timings, std::move(image));
    } catch (const std::exception& error) {
      scheduler_.failed(work);
      server_.fail(work.request.stream, error.what());
    }
  });
}

void RenderLoop::fail(GpuStack& stack, const stream::Work& work, const std::string& message, int status) {
  log::error("a frame could not be rendered: {}", message);
  drop(stack, work.request.stream);
  scheduler_.failed(work);
  server_.fail(work.request.stream, message, status);
}

void RenderLoop::drop(GpuStack& stack, StreamId stream) {
  if (const auto found = active_.find(stream); found != active_.end()) {
    if (found->second.job) stack.renderer.abandon(std::move(found->second.job));
    active_.erase(found);
  }
  stack.renderer.forget(stream);
}

// Streams that were closed and stills that were cancelled since.
void RenderLoop::drop_the_gone(GpuStack& stack) {
  for (const StreamId stream : stack.renderer.remembered()) {
    const auto active = active_.find(stream);
    const bool rendering = active != active_.end() && scheduler_.wanted(active->second.work);
    if (!rendering && !scheduler_.is_open(stream)) drop(stack, stream);
  }
}

}  // namespace cloudscape::app
