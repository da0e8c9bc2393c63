// Frames that nobody watches for: which is next, and when it may go without disturbing those that somebody waits for.
#pragma once
#include <limits>

#include "stream/still_queue.h"

namespace cloudscape::stream {

class Background {
 public:
  explicit Background(const SchedulerOptions& options)
      : quiet_(duration(options.background_quiet_ms)), patience_(duration(options.background_patience_ms)) {}

  StillQueue frames{std::numeric_limits<std::size_t>::max()};

  void others_rendered(Time now) { others_at_ = now; }  // or begin, or go on
  // From when on the next frame, or slice of one, may be rendered; nullopt: there is none.
  std::optional<Time> due_at() const {
    if (!frames.first_ready()) return std::nullopt;
    return std::min(others_at_ + quiet_, served_at_ + patience_);
  }
  std::optional<StreamId> next(Time now) const {
    return due_at().value_or(Time::max()) <= now ? frames.first_ready() : std::nullopt;
  }
  // It has waited so long for quiet that it goes before those that somebody waits for.
  bool impatient(Time now) const { return served_at_ + patience_ <= now; }
  const Work& take(StreamId id, Time now) {
    served_at_ = now;
    return frames.take(id);
  }

 private:
  static Time::duration duration(double ms) {
    return std::chrono::duration_cast<Time::duration>(std::chrono::duration<double, std::milli>(ms));
  }
  Time::duration quiet_, patience_;
  Time others_at_{}, served_at_{};  // the clock's beginning: long ago
};

}  // namespace cloudscape::stream
