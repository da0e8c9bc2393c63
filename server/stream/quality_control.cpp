#include "stream/quality_control.h"

#include <algorithm>

namespace cloudscape::stream {
namespace {

constexpr std::size_t coarsest = moving_details.size() - 1;  // a cloud's edge is 4 pixels wide then

// What a frame costs that follows its detail, in that of a frame that is marched whole: marched pixels, and kept ones.
// tuned: measured on llvmpipe, where a kept pixel is re-projected in a twentieth of the time that a marched one takes,
// and half of that is for steps.
constexpr double work_of(const MovingDetail& detail) {
  const double kept = 1.0 / (detail.resolution_divisor * detail.resolution_divisor);
  return kept / detail.reuse * (0.5 + 0.5 / detail.step_factor) + 0.05 * kept;
}

// tuned: the gap between the two is what keeps a noisy render time from pumping.
constexpr double slow_share = 1.2, fast_share = 0.9;

// tuned: a try of a finer level that fails makes the next wait four times as long, up to 20 s at 25 frames a second;
// one that lasts `proven_frames` has succeeded.
constexpr std::size_t patience_factor = 4, longest_patience = 512, proven_frames = 64;

// How much of a frame's time follows its detail; the rest (tone map, readback) is paid at any.
// All of it is the worst case, so that what fits then is sure to fit. tuned: half of it is a bold guess, for a try that
// fails costs two slow frames, and one that is never made leaves the picture coarse for good.
constexpr double sure_share = 1.0, bold_share = 0.5;

// tuned: fractions of the target that a frame may queue; between them quality stays.
constexpr double congested_share = 0.3, calm_share = 0.1;
// tuned: of the target, between frames: above the one, fewer bytes are worth more frames a second; below the other, a
// queue is no reason for coarser ones.
constexpr double slow_interval_share = 0.7, fast_interval_share = 0.55;
constexpr int lowest_quality = 55, highest_quality = 85;  // tuned: blocks begin to show; more bytes show nothing
constexpr int quality_steps_down = 12;                    // tuned: at once, at most; a third of the bytes
constexpr double bytes_per_quality = 0.02;                // share; libjpeg-turbo, 720p clouds: 30 KB at 50, 75 KB at 90
constexpr int calm_acknowledgements = 5, held_acknowledgements = 3;  // tuned; those under way tell of the old quality

}  // namespace

void DetailControl::rendered(const MovingDetail& detail, double render_ms) {
  if (!(detail == moving_details[level_])) return;
  recent_ms_[held_++ % recent_ms_.size()] = render_ms;
  if (held_ >= proven_frames && tried_finer_) {
    tried_finer_ = false;
    patience_ = first_patience;
  }
  if (render_ms > slow_share * target_ms_) return too_slow(render_ms);
  slow_ms_ = 0;
  if (held_ >= first_patience) look_for_finer();
}

// Two in a row: a single one may be a shader that was compiled, or another program's hiccup.
void DetailControl::too_slow(double render_ms) {
  if (level_ == coarsest) return;
  if (slow_ms_ == 0) {
    slow_ms_ = render_ms;
    return;
  }
  const double whole_ms = std::min(slow_ms_, render_ms) / work_of(moving_details[level_]);
  std::size_t level = level_ + 1;
  while (level < coarsest && whole_ms * work_of(moving_details[level]) > target_ms_) ++level;
  if (tried_finer_) patience_ = std::min(patience_factor * patience_, longest_patience);
  change_to(level);
}

void DetailControl::look_for_finer() {
  const std::size_t bold = finest_affordable(bold_share), sure = finest_affordable(sure_share);
  const std::size_t level = held_ >= patience_ ? bold : sure;
  if (level == level_) return;
  change_to(level);
  tried_finer_ = level < sure;
}

void DetailControl::change_to(std::size_t level) {
  level_ = level;
  slow_ms_ = 0;
  held_ = 0;
  tried_finer_ = false;
}

std::size_t DetailControl::finest_affordable(double following_share) const {
  const double slowest_ms = *std::ranges::max_element(recent_ms_);
  const auto predicted_ms = [&](std::size_t level) {
    const double ratio = work_of(moving_details[level]) / work_of(moving_details[level_]);
    return slowest_ms * (1 - following_share + following_share * ratio);
  };
  for (std::size_t level = 0; level < level_; ++level)
    if (predicted_ms(level) <= fast_share * target_ms_) return level;
  return level_;
}

void JpegControl::acknowledged(double queued_ms, double interval_ms) {
  constexpr double gain = 1.0 / 3;  // tuned: one late acknowledgement alone does not count as a queue
  queued_ms_ += gain * (queued_ms - queued_ms_);
  const bool calm = queued_ms_ < calm_share * target_ms_ || interval_ms < fast_interval_share * target_ms_;
  calm_ = calm ? calm_ + 1 : 0;
  if (hold_ > 0) {
    --hold_;
  } else if (queued_ms_ > congested_share * target_ms_ && interval_ms > slow_interval_share * target_ms_) {
    // Half of what would empty the queue by the next frame: the frames under way empty it too.
    const double excess = std::min(queued_ms_ / std::max(interval_ms, 1.0), 1.0) / 2;
    lower(static_cast<int>(excess / bytes_per_quality));
  } else if (calm_ >= calm_acknowledgements) {
    quality_ = std::min(quality_ + 1, highest_quality);
    calm_ = 0;
  }
}

void JpegControl::dropped() {
  if (hold_ == 0) lower(quality_steps_down / 2);
}

void JpegControl::lower(int by) {
  quality_ = std::max(quality_ - std::clamp(by, 1, quality_steps_down), lowest_quality);
  hold_ = held_acknowledgements;
  calm_ = 0;
}

}  // namespace cloudscape::stream
