// What the acknowledgements of a viewer's moving frames tell about the way to it and back, and how many frames keep
// that way busy.
#pragma once
#include <optional>

namespace cloudscape::stream {

class RoundTrip {
 public:
  struct Sample {
    double transit_ms = 0;  // encoded until acknowledged, without decoding
    double decode_ms = 0;
    bool alone = false;                 // no other frame was under way when it was encoded: it cannot have queued
    std::optional<double> interval_ms;  // since the acknowledgement before, if the frame was under way by then
  };

  void produced(double render_ms, double encode_ms);
  double acknowledged(const Sample& sample);  // the time that the frame queued behind others, ms

  double ms() const { return round_trip_ms_.value_or(0); }  // without queueing; 0 before the first acknowledgement
  double frame_ms() const;                                  // between frames, at the slowest stage of the way
  int window(int max_in_flight) const;

 private:
  bool probing() const;

  std::optional<double> round_trip_ms_, render_ms_, encode_ms_, decode_ms_, interval_ms_;
  int queued_frames_ = 0;  // since one went alone
};

}  // namespace cloudscape::stream
