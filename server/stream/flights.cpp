#include "stream/flights.h"

#include <algorithm>
#include <cmath>

#include "core/milliseconds.h"

namespace cloudscape::stream {
namespace {

// tuned: how soon the window may grow again after a drop, against wasting the frame that would be dropped next.
constexpr int acknowledgements_to_grow = 20;

}  // namespace

Flights::Iterator Flights::find(std::uint32_t frame_id) {
  return std::find_if(frames_.begin(), frames_.end(), [&](const Flight& flight) { return flight.id == frame_id; });
}

void Flights::rendered(std::uint32_t frame_id, bool moving, double render_ms) {
  frames_.push_back({frame_id, moving, render_ms, {}, false, false});
}

void Flights::encoded(std::uint32_t frame_id, double encode_ms, Time now) {
  const auto flight = find(frame_id);
  if (flight == frames_.end() || flight->encoded) return;
  flight->encoded = now;
  flight->alone = flight == frames_.begin();
  flight->measures = std::all_of(frames_.begin(), flight + 1, [](const Flight& each) { return each.moving; });
  if (flight->moving) round_trip_.produced(flight->render_ms, encode_ms);
}

std::optional<Flights::Acknowledged> Flights::acknowledge(std::uint32_t frame_id, double decode_ms, Time now) {
  const auto flight = find(frame_id);
  if (flight == frames_.end()) return {};
  const auto measured = measure(flight, decode_ms, now);
  frames_.erase(frames_.begin(), flight + 1);
  last_acknowledged_ = now;
  if (limit_ < max_ && ++acknowledgements_ % acknowledgements_to_grow == 0) ++limit_;
  return measured;
}

std::optional<Flights::Acknowledged> Flights::measure(Iterator flight, double decode_ms, Time now) {
  if (!flight->encoded) return {};
  const double total_ms = milliseconds(now - *flight->encoded);
  const double transit_ms = std::max(total_ms - plausible_ms(decode_ms), 0.0);
  if (!flight->measures) return Acknowledged{transit_ms, {}};
  RoundTrip::Sample sample{transit_ms, total_ms - transit_ms, flight->alone, {}};
  const auto& first = frames_.front();
  if (last_acknowledged_ && first.encoded && *first.encoded <= *last_acknowledged_)
    sample.interval_ms = milliseconds(now - *last_acknowledged_) / static_cast<double>(flight - frames_.begin() + 1);
  return Acknowledged{transit_ms, round_trip_.acknowledged(sample)};
}

// A drop shows that the window is wider than the way. Without the lower limit a stalled viewer that had a window of
// three would be rendered for without end: each new frame replaces the one that waits, and so makes room for the next.
bool Flights::dropped(std::uint32_t frame_id) {
  const int window_then = window();
  if (!erase(frame_id)) return false;
  limit_ = std::max(window_then - 1, 1);
  acknowledgements_ = 0;
  return true;
}

bool Flights::failed(std::uint32_t frame_id) { return erase(frame_id); }

bool Flights::erase(std::uint32_t frame_id) {
  const auto flight = find(frame_id);
  if (flight == frames_.end()) return false;
  frames_.erase(flight);
  return true;
}

int Flights::window() const { return std::min(round_trip_.window(max_), limit_); }

bool Flights::has_room() const {
  const auto encoding = std::count_if(frames_.begin(), frames_.end(), [](const Flight& each) { return !each.encoded; });
  return encoding <= 1 && std::ssize(frames_) < window();
}

}  // namespace cloudscape::stream
