// A viewer that never rests behind a link with a rate, a way and an endless queue, and the render thread and encoder
// that serve it, in steps of half a millisecond: what the scheduler makes of a real network.
#pragma once
#include <algorithm>
#include <cmath>
#include <deque>

#include "scheduler_test.h"

namespace cloudscape::stream {

class SimulatedViewer {
 public:
  double link_mbit_per_s = 20, one_way_ms = 10, decode_ms = 3;
  double fixed_ms = 4, marched_ms = 12;  // of a frame's render time

  struct Seen {
    double at_ms, age_ms;  // from the start of its render
    int jpeg_quality;
  };
  std::vector<Seen> seen;

  void run(double duration_ms) {
    for (const Time end = now_ + ms(duration_ms); now_ < end; now_ += ms(step_ms)) step();
  }
  StreamStats stats() const { return scheduler_.stats(stream_); }
  double age_ms(double percent, double since_ms) const {
    std::vector<double> ages;
    for (const Seen& frame : seen)
      if (frame.at_ms >= since_ms) ages.push_back(frame.age_ms);
    std::ranges::sort(ages);
    return ages.empty() ? 0 : ages[static_cast<std::size_t>(percent / 100 * static_cast<double>(ages.size() - 1))];
  }
  double serialise_ms() const { return bytes(seen.back().jpeg_quality) * 8 / (link_mbit_per_s * 1000); }
  double now_ms() const { return std::chrono::duration<double, std::milli>(now_ - start).count(); }

 private:
  static constexpr double step_ms = 0.5, encode_ms = 2;
  static constexpr Time start{std::chrono::hours(1)};

  struct Sent {
    Work work;
    Time taken, encoded, shown, acknowledged;
    bool reported = false;
  };

  // 1280x720 clouds: 42 KB at quality 75, and what libjpeg-turbo makes of them at 55 to 85.
  static double bytes(int quality) { return 42'000 * std::exp(0.02 * (quality - 75)); }

  void step() {
    StreamView view;
    view.pose.azimuth_deg = std::floor(now_ms() / 16);  // a screen's 60 Hz
    if (view.pose != view_.pose) scheduler_.update(stream_, view_ = view);
    if (rendering_ && now_ >= render_end_) finish();
    for (Sent& sent : under_way_) report(sent);
    while (!under_way_.empty() && now_ >= under_way_.front().acknowledged) acknowledge();
    if (!rendering_) begin();
  }
  void begin() {
    const auto work = scheduler_.take(now_);
    if (!work) return;
    const RenderQuality& quality = work->request.quality;
    const double kept = 1.0 / (quality.resolution_divisor * quality.resolution_divisor);
    rendering_ = Sent{*work, now_, {}, {}, {}};
    render_end_ = now_ + ms(fixed_ms + marched_ms * (kept / quality.reuse + 0.05 * kept));
  }
  void finish() {
    FrameTimings timings;
    timings.render_ms = std::chrono::duration<double, std::milli>(now_ - rendering_->taken).count();
    scheduler_.rendered(rendering_->work, timings);
    Sent sent = *rendering_;
    rendering_.reset();
    sent.encoded = now_ + ms(encode_ms);
    link_free_ =
        std::max(link_free_, sent.encoded) + ms(bytes(sent.work.encoding.jpeg_quality) * 8 / (link_mbit_per_s * 1000));
    sent.shown = link_free_ + ms(one_way_ms + decode_ms);
    sent.acknowledged = sent.shown + ms(one_way_ms);
    under_way_.push_back(sent);
  }
  void report(Sent& sent) {
    if (sent.reported || now_ < sent.encoded) return;
    sent.reported = true;
    scheduler_.encoded(sent.work, static_cast<std::size_t>(bytes(sent.work.encoding.jpeg_quality)), encode_ms);
  }
  void acknowledge() {
    const Sent& sent = under_way_.front();
    seen.push_back({now_ms(), std::chrono::duration<double, std::milli>(sent.shown - sent.taken).count(),
                    sent.work.encoding.jpeg_quality});
    scheduler_.acknowledge(stream_, sent.work.frame_id, decode_ms);
    under_way_.pop_front();
  }

  Time now_ = start, link_free_ = start, render_end_;
  std::optional<Sent> rendering_;
  std::deque<Sent> under_way_;
  Metrics metrics_;
  FrameScheduler scheduler_{whole_frames(), metrics_, [this] { return now_; }};
  StreamView view_;
  StreamId stream_ = scheduler_.open(view_);
};

}  // namespace cloudscape::stream
