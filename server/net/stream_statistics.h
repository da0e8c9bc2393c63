// What one viewer is told of its stream once a second.
#pragma once
#include <map>
#include <optional>

#include "net/limits.h"
#include "wire/messages.h"

namespace cloudscape::net {

class StreamStatistics {
 public:
  void sent(std::uint32_t frame_id, std::size_t bytes, double render_ms, double encode_ms, Instant now);
  void acknowledged(std::uint32_t frame_id, Instant now);
  void dropped() { ++dropped_; }
  // Of the time since the last call; nullopt where no frame was sent since.
  std::optional<wire::Stats> take(Instant now);

 private:
  std::map<std::uint32_t, Instant> in_flight_;
  Instant since_{};
  int frames_ = 0, window_ = 0;
  double bytes_ = 0, render_ms_ = 0, encode_ms_ = 0, round_trip_ms_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace cloudscape::net
