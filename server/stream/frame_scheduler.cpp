#include "stream/frame_scheduler.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <map>
#include <mutex>
#include <utility>

#include "core/milliseconds.h"
#include "stream/background.h"
#include "stream/bills.h"
#include "stream/still_queue.h"
#include "stream/turns.h"
#include "stream/viewer_stream.h"

namespace cloudscape::stream {
namespace {

StreamId new_id() {
  static std::atomic<StreamId> last = 0;
  return ++last;
}

// Long enough to cost nothing, short enough that a deadline of "never" cannot overflow the system's clock.
constexpr std::chrono::minutes longest_wait{10};

}  // namespace

struct FrameScheduler::State {
  State(const SchedulerOptions& its_options, Metrics& its_metrics, Clock its_clock)
      : options(its_options),
        metrics(its_metrics),
        clock(std::move(its_clock)),
        stills(its_options.still_queue),
        background(its_options) {}

  const SchedulerOptions options;
  Metrics& metrics;
  const Clock clock;
  mutable std::mutex mutex;
  std::condition_variable changed;
  std::map<StreamId, ViewerStream> streams;
  StillQueue stills;
  Background background;
  Turns turns;
  Bills bills;
  bool stopped = false;

  // Runs `apply(state, now)` under the lock; then a waiting `take` looks again.
  void change(auto&& apply) {
    {
      const std::lock_guard lock(mutex);
      apply(*this, clock());
      publish();
    }
    changed.notify_all();
  }

  void change_stream(StreamId id, auto&& apply) {
    change([&](State&, Time now) {
      if (ViewerStream* viewer = stream(id)) apply(*viewer, now);
    });
  }

  ViewerStream* stream(StreamId id) {
    const auto found = streams.find(id);
    return found == streams.end() ? nullptr : &found->second;
  }

  std::optional<StreamId> next(Time now) {
    const auto stream_ready = [&](StreamId id) {
      const ViewerStream* viewer = stream(id);
      return viewer && viewer->ready_at().value_or(Time::max()) <= now;
    };
    const auto watched = turns.next(stream_ready, [&](StreamId id) { return stills.ready(id); });
    const auto unwatched = background.next(now);
    return unwatched && (!watched || background.impatient(now)) ? unwatched : watched;
  }

  Work serve(StreamId id, Time now) {
    if (background.frames.contains(id)) return background.take(id, now);
    background.others_rendered(now);
    ViewerStream* viewer = stream(id);
    turns.served(id, viewer == nullptr);
    const Work work = viewer ? viewer->take(now) : stills.take(id);
    bills.taken(work, now);
    return work;
  }

  bool yield(const Work& work, Time now) {
    if (stopped) return false;
    if (background.frames.yield(work.request.stream)) return true;
    background.others_rendered(now);
    ViewerStream* viewer = stream(work.request.stream);
    if (viewer || stills.contains(work.request.stream))
      turns.charge(work.request.stream, work.still, bills.yielded(work, now));
    if (work.still) return stills.yield(work.request.stream);
    if (!viewer || !viewer->in_render(work)) return false;
    const bool wanted = viewer->yield(work);
    if (!wanted) count_dropped("abandoned");
    return wanted;
  }

  // When time alone makes a stream, or the background, ready.
  Time next_due() const {
    Time due = background.due_at().value_or(Time::max());
    for (const auto& [id, viewer] : streams) due = std::min(due, viewer.ready_at().value_or(due));
    return due;
  }

  bool end_still(StreamId id) {
    leave(id);
    return stills.end(id);
  }

  void leave(StreamId id) {
    turns.leave(id);
    bills.forget(id);
  }

  // What a work that is rendered counts as; "": nobody waits for it any more.
  std::string end(const Work& work, const FrameTimings& timings, double render_ms, Time now) {
    const StreamId id = work.request.stream;
    if (background.frames.end(id)) return "background";
    background.others_rendered(now);
    ViewerStream* viewer = stream(id);
    if (viewer || stills.contains(id)) turns.charge(id, work.still, bills.ended(work, timings));
    if (work.still) return end_still(id) ? "still" : "";
    return viewer && viewer->rendered(work, render_ms, turn_ms(timings, render_ms, now), now) ? "stream" : "";
  }

  // A frame's time with those of all streams that move, which share one device: what each may take is less the more
  // there are. A GPU works on while the render thread has long gone on to the next frame.
  double turn_ms(const FrameTimings& timings, double render_ms, Time now) const {
    const auto moving = std::ranges::count_if(streams, [&](const auto& entry) { return entry.second.moves(now); });
    return std::max(render_ms, plausible_ms(timings.gpu_ms)) * static_cast<double>(std::max<std::ptrdiff_t>(moving, 1));
  }

  void count_dropped(const char* reason) {
    metrics.count("cloudscape_frames_dropped_total{reason=\"" + std::string(reason) + "\"}");
  }

  void publish() {
    std::size_t in_flight = 0;
    for (const auto& [id, viewer] : streams) in_flight += viewer.in_flight();
    metrics.set("cloudscape_streams_open", static_cast<double>(streams.size()));
    metrics.set("cloudscape_stills_waiting", static_cast<double>(stills.size()));
    metrics.set("cloudscape_frames_in_flight", static_cast<double>(in_flight));
  }
};

FrameScheduler::FrameScheduler(SchedulerOptions options, Metrics& metrics, Clock clock)
    : state_(std::make_unique<State>(options, metrics, std::move(clock))) {
  state_->publish();
}

FrameScheduler::~FrameScheduler() = default;

StreamId FrameScheduler::open(const StreamView& view) {
  const StreamId id = new_id();
  state_->change([&](State& state, Time now) {
    state.streams.try_emplace(id, id, view, state.options, now);
    state.turns.join(id);
  });
  return id;
}

void FrameScheduler::update(StreamId stream, const StreamView& view) {
  state_->change_stream(stream, [&](ViewerStream& viewer, Time now) {
    if (viewer.update(view, now)) state_->count_dropped("abandoned");
  });
}

void FrameScheduler::acknowledge(StreamId stream, std::uint32_t frame_id, double decode_ms) {
  state_->change_stream(stream, [&](ViewerStream& viewer, Time now) {
    if (const auto acknowledged = viewer.acknowledge(frame_id, decode_ms, now))
      state_->metrics.observe_ms("cloudscape_ack_ms", acknowledged->transit_ms);
  });
}

void FrameScheduler::close(StreamId stream) {
  state_->change([&](State& state, Time) {
    if (state.streams.erase(stream) > 0) state.leave(stream);
  });
}

void FrameScheduler::dropped(StreamId stream, std::uint32_t frame_id) {
  state_->change_stream(stream, [&](ViewerStream& viewer, Time) {
    if (viewer.dropped(frame_id)) state_->count_dropped("replaced");
  });
}

StreamStats FrameScheduler::stats(StreamId stream) const {
  const std::lock_guard lock(state_->mutex);
  const ViewerStream* viewer = state_->stream(stream);
  return viewer ? viewer->stats(state_->clock()) : StreamStats{};
}

std::optional<StreamId> FrameScheduler::submit_still(FrameRequest request, const Encoding& encoding) {
  std::optional<StreamId> id;
  state_->change([&](State& state, Time now) {
    if (state.stopped || state.stills.full()) return state.metrics.count("cloudscape_stills_refused_total");
    id = new_id();
    state.stills.submit(*id, std::move(request), encoding, now);
    state.turns.join(*id);
  });
  return id;
}

std::optional<StreamId> FrameScheduler::submit_background(FrameRequest request, const Encoding& encoding) {
  std::optional<StreamId> id;
  state_->change([&](State& state, Time now) {
    if (state.stopped) return;
    id = new_id();
    state.background.frames.submit(*id, std::move(request), encoding, now);
  });
  return id;
}

void FrameScheduler::cancel_still(StreamId still) {
  state_->change([&](State& state, Time) {
    state.background.frames.end(still);
    if (state.end_still(still)) state.metrics.count("cloudscape_stills_cancelled_total");
  });
}

std::size_t FrameScheduler::stills_waiting() const {
  const std::lock_guard lock(state_->mutex);
  return state_->stills.size();
}

std::optional<Work> FrameScheduler::take(Time deadline) {
  std::unique_lock lock(state_->mutex);
  while (!state_->stopped) {
    const Time now = state_->clock();
    if (const auto id = state_->next(now)) return state_->serve(*id, now);
    if (now >= deadline) return {};
    const auto wait = std::min(deadline, state_->next_due()) - now;
    state_->changed.wait_for(lock, std::min<Time::duration>(wait, longest_wait));
  }
  return {};
}

bool FrameScheduler::yield(const Work& work) {
  bool wanted = false;
  state_->change([&](State& state, Time now) { wanted = state.yield(work, now); });
  return wanted;
}

bool FrameScheduler::wanted(const Work& work) const {
  const std::lock_guard lock(state_->mutex);
  if (state_->stopped) return false;
  const StreamId id = work.request.stream;
  if (work.still) return state_->stills.contains(id) || state_->background.frames.contains(id);
  const ViewerStream* viewer = state_->stream(work.request.stream);
  return viewer && viewer->wanted(work);
}

void FrameScheduler::rendered(const Work& work, const FrameTimings& timings) {
  const double render_ms = plausible_ms(timings.render_ms);
  state_->change([&](State& state, Time now) {
    const std::string kind = state.end(work, timings, render_ms, now);
    if (kind.empty()) return;
    state.metrics.count("cloudscape_frames_rendered_total{kind=\"" + kind + "\"}");
    if (kind == "background") return;
    state.metrics.observe_ms("cloudscape_queue_ms", plausible_ms(timings.queue_ms));
    state.metrics.observe_ms("cloudscape_render_ms", render_ms);
  });
}

void FrameScheduler::encoded(const Work& work, std::size_t bytes, double encode_ms) {
  const double ms = plausible_ms(encode_ms);
  state_->metrics.observe_ms("cloudscape_encode_ms", ms);
  if (work.still) return;
  state_->change_stream(work.request.stream,
                        [&](ViewerStream& viewer, Time now) { viewer.encoded(work, bytes, ms, now); });
}

void FrameScheduler::failed(const Work& work) {
  state_->change([&](State& state, Time) {
    const StreamId id = work.request.stream;
    ViewerStream* viewer = state.stream(id);
    const bool background = state.background.frames.end(id);
    if (background || (work.still ? state.end_still(id) : viewer && viewer->failed(work)))
      state.count_dropped("failed");
  });
}

bool FrameScheduler::is_open(StreamId stream) const {
  const std::lock_guard lock(state_->mutex);
  return state_->stream(stream) != nullptr;
}

bool FrameScheduler::stopped() const {
  const std::lock_guard lock(state_->mutex);
  return state_->stopped;
}

void FrameScheduler::stop() {
  state_->change([](State& state, Time) { state.stopped = true; });
}

}  // namespace cloudscape::stream
