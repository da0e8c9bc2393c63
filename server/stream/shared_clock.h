// The clock of a document: all who look at it see the same time, and each of them may turn it. It costs nothing while
// it runs: the time follows from when it was last changed.
#pragma once
#include "core/clock.h"

namespace cloudscape::stream {

class SharedClock {
 public:
  using Time = RunningTime::Instant;
  void change(const ClockChange& change, Time now);
  ClockState read(Time now) const { return {time_.at(now), rate_, paused_}; }
  const RunningTime& running() const { return time_; }

 private:
  RunningTime time_;
  double rate_ = 1;
  bool paused_ = true;
};

inline void SharedClock::change(const ClockChange& change, Time now) {
  const double time_s = change.time_s.value_or(time_.at(now));
  rate_ = change.rate.value_or(rate_);
  paused_ = change.paused.value_or(paused_);
  time_ = {time_s, paused_ ? 0 : rate_, now};
}

}  // namespace cloudscape::stream
