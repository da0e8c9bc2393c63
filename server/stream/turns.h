// Round robin: who was served goes to the back.
#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "core/frame.h"

namespace cloudscape::stream {

class Turns {
 public:
  void join(StreamId id) { ring_.push_back(id); }
  void leave(StreamId id) { std::erase(ring_, id); }

  // The first that is ready, by two predicates on an id. While a stream is ready, no two stills follow each other, so
  // that however many stills there are, streams have half of the turns.
  std::optional<StreamId> next(auto&& stream_ready, auto&& still_ready) const {
    const auto stream = std::ranges::find_if(ring_, stream_ready), still = std::ranges::find_if(ring_, still_ready);
    if (stream == ring_.end() && still == ring_.end()) return {};
    const bool stream_first = still == ring_.end() || (stream != ring_.end() && (stream < still || last_was_still_));
    return *(stream_first ? stream : still);
  }

  void served(StreamId id, bool still) {
    const auto served = std::ranges::find(ring_, id);
    if (served != ring_.end()) std::rotate(served, served + 1, ring_.end());
    last_was_still_ = still;
  }

 private:
  std::vector<StreamId> ring_;
  bool last_was_still_ = false;
};

}  // namespace cloudscape::stream
