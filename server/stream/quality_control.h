// What a moving frame may cost: how much of it is marched anew, from its render time, and how hard its JPEG is
// compressed, from the queue in front of the viewer. Both give way fast and return slowly.
#pragma once
#include <array>
#include <cstddef>

#include "core/quality.h"

namespace cloudscape::stream {

// How much of a moving picture is marched anew in each frame, at which resolution it is kept (core/quality.h), and in
// steps how many times as long.
struct MovingDetail {
  int reuse = 1, resolution_divisor = 1, step_factor = 1;
  bool operator==(const MovingDetail&) const = default;
};
// Finest first; each costs less than the one before. Longer steps come last: they miss wisps, and change how bright
// clouds are.
constexpr std::array<MovingDetail, 8> moving_details{
    {{1, 1}, {4, 1}, {16, 1}, {4, 2}, {16, 2}, {16, 3}, {16, 4}, {16, 4, 2}}};

constexpr RenderQuality moving_quality(const MovingDetail& detail) {
  RenderQuality quality = render_quality(Quality::interactive);
  quality.reuse = detail.reuse;
  quality.resolution_divisor = detail.resolution_divisor;
  quality.step_m *= detail.step_factor;
  quality.step_growth *= detail.step_factor;
  quality.samples = 1;
  return quality;
}

// Which of them a frame was rendered at; the finest where at none.
constexpr int moving_detail_of(const RenderQuality& quality) {
  for (std::size_t i = 0; i < moving_details.size(); ++i)
    if (moving_quality(moving_details[i]) == quality) return static_cast<int>(i);
  return 0;
}

// The detail of moving frames, so that a frame renders within the target.
class DetailControl {
 public:
  DetailControl(double target_frame_ms, std::size_t first) : target_ms_(target_frame_ms), level_(first) {}
  const MovingDetail& detail() const { return moving_details[level_]; }
  void rendered(const MovingDetail& detail, double render_ms);

 private:
  static constexpr std::size_t first_patience = 8;  // tuned: frames at a level before a finer one

  void too_slow(double render_ms);
  void look_for_finer();
  void change_to(std::size_t level);
  std::size_t finest_affordable(double following_share) const;

  double target_ms_;
  std::size_t level_;
  std::size_t held_ = 0;                            // frames at this level
  std::array<double, first_patience> recent_ms_{};  // of the last of them
  double slow_ms_ = 0;                              // the frame before, if it was too slow
  bool tried_finer_ = false;                        // this level is a bold try
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
