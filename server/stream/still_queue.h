// The stills that wait or render; only few render at once.
#pragma once
#include <map>

#include "stream/frame_scheduler.h"

namespace cloudscape::stream {

class StillQueue {
 public:
  explicit StillQueue(std::size_t capacity) : capacity_(capacity) {}

  std::size_t size() const { return stills_.size(); }
  bool full() const { return size() >= capacity_; }
  void submit(StreamId id, FrameRequest request, const Encoding& encoding, Time now);
  bool end(StreamId id) { return stills_.erase(id) > 0; }  // done, failed or cancelled; false: it is unknown

  bool contains(StreamId id) const { return stills_.contains(id); }
  bool ready(StreamId id) const;                // to be taken now
  std::optional<StreamId> first_ready() const;  // by age
  const Work& take(StreamId id);
  bool yield(StreamId id);  // false: it is unknown

 private:
  enum class State { waiting, rendering, yielded };
  struct Still {
    Work work;
    State state = State::waiting;
  };
  std::size_t capacity_;
  std::map<StreamId, Still> stills_;
};

}  // namespace cloudscape::stream
