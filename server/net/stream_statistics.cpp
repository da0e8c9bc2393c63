#include "net/stream_statistics.h"

#include <algorithm>

namespace cloudscape::net {
namespace {

constexpr std::size_t max_in_flight = 16;  // far more than the scheduler lets out; bounds a viewer that never answers

double ms(Instant::duration duration) { return std::chrono::duration<double, std::milli>(duration).count(); }

}  // namespace

void StreamStatistics::sent(std::uint32_t frame_id, std::size_t bytes, double render_ms, double encode_ms,
                            Instant now) {
  if (since_ == Instant{}) since_ = now;
  in_flight_[frame_id] = now;
  if (in_flight_.size() > max_in_flight) in_flight_.erase(in_flight_.begin());
  window_ = std::max(window_, static_cast<int>(in_flight_.size()));
  ++frames_;
  bytes_ += static_cast<double>(bytes);
  render_ms_ += render_ms;
  encode_ms_ += encode_ms;
}

void StreamStatistics::acknowledged(std::uint32_t frame_id, Instant now) {
  const auto found = in_flight_.find(frame_id);
  if (found == in_flight_.end()) return;
  round_trip_ms_ = ms(now - found->second);
  in_flight_.erase(in_flight_.begin(), std::next(found));  // frames are displayed in order: older ones were skipped
}

std::optional<wire::Stats> StreamStatistics::take(Instant now) {
  if (frames_ == 0 || now <= since_) {
    since_ = now;
    return std::nullopt;
  }
  const double seconds = ms(now - since_) / 1e3;
  const wire::Stats stats{frames_ / seconds,    bytes_ * 8 / seconds, round_trip_ms_,
                          render_ms_ / frames_, encode_ms_ / frames_, dropped_,
                          std::max(1, window_)};
  since_ = now;
  frames_ = window_ = 0;
  bytes_ = render_ms_ = encode_ms_ = 0;
  return stats;
}

}  // namespace cloudscape::net
