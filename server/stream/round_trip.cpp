#include "stream/round_trip.h"

#include <algorithm>
#include <cmath>

namespace cloudscape::stream {
namespace {

constexpr int first_window = 2;  // one on its way while the next is rendered

// tuned: some 2 s of a saturated link, at a cost of 1 % of its frames. Then one frame goes alone, as BBR probes its
// minimal round trip (draft-cardwell-iccrg-bbr, ProbeRTT); else a queue that never empties would pass for a long way.
constexpr int queued_frames_between_probes = 40;
constexpr double queued_ratio = 1.25;  // tuned: of the transit to the round trip; less is jitter

// tuned: where the window itself limits the frame rate, the measured share is exactly the window; the margin lets it
// grow.
constexpr double growing_margin = 0.15;

void smooth(std::optional<double>& mean, double value) {
  constexpr double gain = 0.25;  // tuned: follows a change within some 8 frames, halves jitter
  mean = mean ? *mean + gain * (value - *mean) : value;
}

}  // namespace

void RoundTrip::produced(double render_ms, double encode_ms) {
  smooth(render_ms_, render_ms);
  smooth(encode_ms_, encode_ms);
}

double RoundTrip::acknowledged(const Sample& sample) {
  smooth(decode_ms_, sample.decode_ms);
  if (sample.interval_ms) smooth(interval_ms_, *sample.interval_ms);
  if (sample.alone || !round_trip_ms_) {
    if (probing()) round_trip_ms_.reset();  // what was known is old
    smooth(round_trip_ms_, sample.transit_ms);
    if (interval_ms_) interval_ms_ = std::min(*interval_ms_, sample.transit_ms);
    queued_frames_ = 0;
    return 0;
  }
  const double queued_ms = std::max(sample.transit_ms - *round_trip_ms_, 0.0);
  if (sample.transit_ms > queued_ratio * *round_trip_ms_) ++queued_frames_;
  round_trip_ms_ = std::min(*round_trip_ms_, sample.transit_ms);
  return queued_ms;
}

bool RoundTrip::probing() const { return queued_frames_ >= queued_frames_between_probes; }

double RoundTrip::frame_ms() const {
  return std::max({render_ms_.value_or(0), encode_ms_.value_or(0), interval_ms_.value_or(0), 1.0});
}

// Little's law: the frames on a way are its rate times its length, here one frame every `frame_ms`. Every further frame
// would only wait: at 20 Mbit/s the frame rate was measured to be the same with 1, 2 and 3 frames of 120 KB in flight,
// and their age 48, 96 and 144 ms.
int RoundTrip::window(int max_in_flight) const {
  if (!interval_ms_) return std::min(first_window, max_in_flight);  // a link may still prove slow
  if (probing()) return 1;
  const double way_ms = render_ms_.value_or(0) + encode_ms_.value_or(0) + *round_trip_ms_ + decode_ms_.value_or(0);
  const double frames = std::min(way_ms / frame_ms(), static_cast<double>(max_in_flight));
  return std::clamp(static_cast<int>(std::ceil(frames + growing_margin)), 1, max_in_flight);
}

}  // namespace cloudscape::stream
