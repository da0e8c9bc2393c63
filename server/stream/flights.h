// The frames of one stream that are rendered and not yet acknowledged or dropped, and how many there may be.
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "stream/frame_scheduler.h"
#include "stream/round_trip.h"

namespace cloudscape::stream {

class Flights {
 public:
  struct Acknowledged {
    double transit_ms = 0;            // encoded until acknowledged, without decoding
    std::optional<double> queued_ms;  // of that behind other frames; only moving frames tell
  };

  explicit Flights(int max_in_flight) : max_(max_in_flight < 1 ? 1 : max_in_flight), limit_(max_) {}

  void rendered(std::uint32_t frame_id, bool moving, double render_ms);
  void encoded(std::uint32_t frame_id, double encode_ms, Time now);
  // Retires the frame and all before it. nullopt: it is unknown, or the encoder has not told yet when it was done.
  std::optional<Acknowledged> acknowledge(std::uint32_t frame_id, double decode_ms, Time now);
  bool dropped(std::uint32_t frame_id);  // false: it is not in flight
  bool failed(std::uint32_t frame_id);

  std::size_t size() const { return frames_.size(); }
  int window() const;
  bool has_room() const;  // for one more, to be rendered while at most one is in the encoder
  const RoundTrip& round_trip() const { return round_trip_; }

 private:
  struct Flight {
    std::uint32_t id = 0;
    bool moving = false;
    double render_ms = 0;
    std::optional<Time> encoded;
    bool alone = false;     // nothing was under way when it was encoded
    bool measures = false;  // it moves, and queued behind nothing but moving frames
  };
  using Iterator = std::deque<Flight>::iterator;
  Iterator find(std::uint32_t frame_id);
  std::optional<Acknowledged> measure(Iterator flight, double decode_ms, Time now);
  bool erase(std::uint32_t frame_id);

  int max_;
  int limit_;  // below max_ after a drop
  int acknowledgements_ = 0;
  std::deque<Flight> frames_;
  std::optional<Time> last_acknowledged_;
  RoundTrip round_trip_;
};

}  // namespace cloudscape::stream
