// Frames and bytes a second over the last two seconds, for people to read.
#pragma once
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <deque>

#include "core/milliseconds.h"
#include "stream/frame_scheduler.h"

namespace cloudscape::stream {

class FrameMeter {
 public:
  explicit FrameMeter(Time start) : start_(start) {}

  void add(std::size_t bytes, Time now) {
    frames_.push_back({now, bytes});
    while (now - frames_.front().time > span) frames_.pop_front();
  }
  double frames_per_second(Time now) const {
    return per_second(now, [](const Sent&) { return 1.0; });
  }
  double bits_per_second(Time now) const {
    return per_second(now, [](const Sent& frame) { return 8.0 * static_cast<double>(frame.bytes); });
  }

 private:
  struct Sent {
    Time time;
    std::size_t bytes;
  };
  static constexpr std::chrono::seconds span{2};             // tuned: calm to read, and soon true
  static constexpr std::chrono::milliseconds shortest{500};  // tuned: a stream's first frame is no rate yet

  double per_second(Time now, auto amount) const {
    double total = 0;
    for (const Sent& frame : frames_)
      if (now - frame.time <= span) total += amount(frame);
    return 1000 * total / milliseconds(std::clamp<Time::duration>(now - start_, shortest, span));
  }

  Time start_;
  std::deque<Sent> frames_;
};

}  // namespace cloudscape::stream
