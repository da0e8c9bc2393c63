// What a moving frame may cost: how coarsely its clouds are marched, from its render time, and how hard its JPEG is
// compressed, from the queue in front of the viewer. Both give way fast and return slowly.
#pragma once
#include <array>
#include <cstddef>

namespace cloudscape::stream {

// march_divisor of moving frames, so that a frame renders within the target.
class MarchControl {
 public:
  explicit MarchControl(double target_frame_ms) : target_ms_(target_frame_ms) {}
  int divisor() const { return divisor_; }
  void rendered(int divisor, double render_ms);

 private:
  static constexpr std::size_t first_patience = 8;  // tuned: frames at a divisor before a finer one

  void too_slow(double render_ms);
  void look_for_finer();
  void change_to(int divisor);
  int finest_affordable(double marched_share) const;

  double target_ms_;
  int divisor_ = 1;
  std::size_t held_ = 0;                            // frames at this divisor
  std::array<double, first_patience> recent_ms_{};  // of the last of them
  double slow_ms_ = 0;                              // the frame before, if it was too slow
  bool tried_finer_ = false;                        // this divisor is a bold try
  std::size_t patience_ = first_patience;
};

// jpeg_quality of moving frames.
class JpegControl {
 public:
  explicit JpegControl(double target_frame_ms) : target_ms_(target_frame_ms) {}
  int quality() const { return quality_; }
  // An acknowledged frame waited `queued_ms` behind earlier ones on a way that lets one pass every `interval_ms`.
  void acknowledged(double queued_ms, double interval_ms);
  void dropped();  // the socket was not ready in time

 private:
  void lower(int by);

  double target_ms_;
  int quality_ = 78;
  double queued_ms_ = 0;  // smoothed
  int calm_ = 0, hold_ = 0;
};

}  // namespace cloudscape::stream
