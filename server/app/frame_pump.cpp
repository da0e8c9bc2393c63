#include "app/frame_pump.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "core/error.h"
#include "core/log.h"
#include "core/milliseconds.h"
#include "encode/encode.h"

namespace cloudscape::app {
namespace {

using Clock = std::chrono::steady_clock;

// tuned: while the device renders one frame another is prepared, so that it is never idle; more would only be older.
constexpr std::size_t most_pending = 2;
// tuned: how often the thread looks whether the device is done, while it waits for work; each look takes microseconds.
constexpr auto look_whether_ready = std::chrono::microseconds(200);

// One core in four encodes; JPEG takes a twentieth of what a frame takes to render without a GPU.
unsigned encoder_threads() { return std::max(1U, std::thread::hardware_concurrency() / 4); }

}  // namespace

FramePump::FramePump(stream::FrameScheduler& scheduler, render::Renderer& renderer, Sink sink)
    : scheduler_(scheduler), renderer_(renderer), sink_(std::move(sink)), encoders_(encoder_threads()) {}

FramePump::~FramePump() = default;

bool FramePump::step(stream::Time deadline) {
  collect_ready();
  const bool waits = !pending_.empty();
  const auto work = scheduler_.take(waits ? std::min(deadline, Clock::now() + look_whether_ready) : deadline);
  if (work)
    advance(*work);
  else if (waits && scheduler_.stopped())
    collect_oldest();
  return work || waits;
}

void FramePump::collect_ready() {
  while (!pending_.empty() && pending_.front().frame.ready()) collect_oldest();
}

// The unfinished job of this very work, or a new one.
FramePump::Active& FramePump::active_of(const stream::Work& work) {
  Active& active = active_[work.request.stream];
  if (active.job && active.work.request.sequence == work.request.sequence && active.work.frame_id == work.frame_id)
    return active;
  if (active.job) renderer_.abandon(std::move(active.job));
  active = {work, renderer_.begin(work.request), ms_since(work.queued)};
  return active;
}

void FramePump::advance(const stream::Work& work) {
  try {
    Active& active = active_of(work);
    if (!renderer_.advance(*active.job)) {
      tell_progress(active);
      if (!scheduler_.yield(work)) drop(work.request.stream);
      return;
    }
    if (pending_.size() >= most_pending) collect_oldest();
    pending_.push_back({work, renderer_.finish(std::move(active.job))});
    pending_.back().frame.timings.queue_ms = active.queue_ms;
    active_.erase(work.request.stream);
  } catch (const UnusableFile& error) {
    fail(work, error.what(), 422);
  } catch (const std::exception& error) {
    fail(work, error.what());
  }
}

void FramePump::tell_progress(Active& active) {
  constexpr auto pause = std::chrono::milliseconds(250);  // tuned: a bar that moves
  if (!active.job->trace || Clock::now() - active.told < pause) return;
  active.told = Clock::now();
  sink_.tell_samples(active.work.request.stream, render::share_done(*active.job->trace),
                     render::mean_samples(*active.job->trace));
}

void FramePump::collect_oldest() {
  Pending pending = std::move(pending_.front());
  pending_.pop_front();
  try {
    Frame frame = renderer_.collect(std::move(pending.frame));
    if (pending.work.still) renderer_.forget(pending.work.request.stream);
    scheduler_.rendered(pending.work, frame.timings);
    encode(pending.work, std::move(frame));
  } catch (const std::exception& error) {
    fail(pending.work, error.what());
  }
}

void FramePump::encode(const stream::Work& work, Frame frame) {
  encoders_.run([this, work, frame = std::make_shared<Frame>(std::move(frame))] {
    try {
      EncodedFrame image = encode::encode(*frame, work.encoding, work.still ? 0 : sink_.front);
      if (!work.still) scheduler_.encoded(work, image.bytes.size() - image.front, image.encode_ms);
      sink_.deliver(work, frame->timings, std::move(image));
    } catch (const std::exception& error) {
      scheduler_.failed(work);
      sink_.fail(work.request.stream, error.what(), 500);
    }
  });
}

void FramePump::fail(const stream::Work& work, const std::string& message, int status) {
  log::error("a frame could not be rendered: {}", message);
  drop(work.request.stream);
  scheduler_.failed(work);
  sink_.fail(work.request.stream, message, status);
}

void FramePump::drop(StreamId stream) {
  if (const auto found = active_.find(stream); found != active_.end()) {
    if (found->second.job) renderer_.abandon(std::move(found->second.job));
    active_.erase(found);
  }
  renderer_.forget(stream);
}

void FramePump::drop_the_gone() {
  for (const StreamId stream : renderer_.remembered()) {
    const auto active = active_.find(stream);
    const bool rendering = active != active_.end() && scheduler_.wanted(active->second.work);
    if (!rendering && !scheduler_.is_open(stream)) drop(stream);
  }
}

}  // namespace cloudscape::app
