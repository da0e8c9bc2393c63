// Whose turn it is, so that all who want the renderer have the same share of its time, however long their turns are:
// start-time fair queueing (Goyal, Vin and Cheng 1996). A turn begins where the last one of its owner ended, or now if
// that is later, and ends what it cost after that; the one that begins first is next, and among equals who was served
// longest ago. Nobody saves up time while he wants nothing. All stills together have the share of one stream.
#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "core/frame.h"

namespace cloudscape::stream {

class Turns {
 public:
  void join(StreamId id) { ring_.push_back({id}); }
  void leave(StreamId id) {
    std::erase_if(ring_, [id](const Owner& owner) { return owner.id == id; });
  }

  // By two predicates on an id. While a stream is ready, no two stills follow each other, so that however short the
  // turns of stills are, streams have half of the turns.
  std::optional<StreamId> next(auto&& stream_ready, auto&& still_ready) const {
    auto stream = ring_.end();
    for (auto owner = ring_.begin(); owner != ring_.end(); ++owner)
      if (stream_ready(owner->id) && (stream == ring_.end() || begins_ms(*owner) < begins_ms(*stream))) stream = owner;
    const auto still = std::ranges::find_if(ring_, still_ready, &Owner::id);
    if (stream == ring_.end() && still == ring_.end()) return {};
    if (stream == ring_.end() || still == ring_.end()) return std::min(stream, still)->id;
    const double stream_ms = begins_ms(*stream), still_ms = std::max(stills_end_ms_, now_ms_);
    const bool stream_first = stream_ms < still_ms || (stream_ms == still_ms && stream < still);
    return stream_first || last_was_still_ ? stream->id : still->id;
  }

  void served(StreamId id, bool still) {
    const auto owner = find(id);
    if (owner == ring_.end()) return;
    double& end_ms = still ? stills_end_ms_ : owner->end_ms;
    now_ms_ = end_ms = std::max(end_ms, now_ms_);
    std::rotate(owner, owner + 1, ring_.end());
    last_was_still_ = still;
  }

  // What the turns of this owner cost beyond what was charged before; less than nothing if that was too much.
  void charge(StreamId id, bool still, double ms) {
    const auto owner = find(id);
    if (still)
      stills_end_ms_ += ms;
    else if (owner != ring_.end())
      owner->end_ms += ms;
  }

 private:
  struct Owner {
    StreamId id;
    double end_ms = 0;  // of its last turn, in the time that all share; not of a still
  };
  double begins_ms(const Owner& owner) const { return std::max(owner.end_ms, now_ms_); }
  std::vector<Owner>::iterator find(StreamId id) { return std::ranges::find(ring_, id, &Owner::id); }

  std::vector<Owner> ring_;  // served longest ago first
  double stills_end_ms_ = 0, now_ms_ = 0;
  bool last_was_still_ = false;
};

}  // namespace cloudscape::stream
