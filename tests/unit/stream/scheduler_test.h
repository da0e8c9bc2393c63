// A scheduler on a clock that stands still unless the test moves it, and short words for what its users do.
#pragma once
#include <gtest/gtest.h>

#include <vector>

#include "stream/frame_scheduler.h"

namespace cloudscape::stream {

inline Time::duration ms(double value) {
  return std::chrono::duration_cast<Time::duration>(std::chrono::duration<double, std::milli>(value));
}

// Frames of 50 ms, marched whole: no frame follows a view that rests but its refinement.
inline SchedulerOptions whole_frames() {
  SchedulerOptions options;
  options.target_frame_ms = 50;
  options.first_detail = 0;
  return options;
}

class SchedulerTest : public testing::Test {
 protected:
  static StreamView looking(double azimuth_deg, Quality quality = Quality::standard) {
    static const auto sky = std::make_shared<const Cloudscape>();
    StreamView view;
    view.cloudscape = sky;
    view.pose.azimuth_deg = azimuth_deg;
    view.quality = quality;
    return view;
  }

  std::optional<Work> take() { return scheduler.take(now); }  // at once or not at all
  void pass(double time_ms) { now += ms(time_ms); }
  void render(const Work& work, double render_ms = 20) {
    pass(render_ms);
    FrameTimings timings;
    timings.render_ms = render_ms;
    scheduler.rendered(work, timings);
  }
  // Renders and encodes, as for a viewer that has not answered yet.
  void send(const Work& work, double render_ms = 20, std::size_t bytes = 40'000) {
    render(work, render_ms);
    scheduler.encoded(work, bytes, 0);
  }
  void show(const Work& work, double render_ms = 20) {
    send(work, render_ms);
    scheduler.acknowledge(work.request.stream, work.frame_id, 0);
  }
  // Moves on a long way until three frames may be in flight; leaves a changed view.
  void widen(StreamId stream) {
    for (int i = 0; i < 10; ++i) {
      std::vector<Work> works;
      for (int frame = 0; frame < 2; ++frame) {
        scheduler.update(stream, looking(1000 + 2 * i + frame));
        works.push_back(*take());
        send(works.back(), 10);
      }
      pass(200);
      for (const Work& work : works) {
        scheduler.acknowledge(stream, work.frame_id, 0);
        pass(10);
      }
    }
    ASSERT_EQ(scheduler.stats(stream).window, 3);
    scheduler.update(stream, looking(2000));
  }
  double dropped(const std::string& reason) const {
    return metrics.value("cloudscape_frames_dropped_total{reason=\"" + reason + "\"}");
  }
  // Renders and shows frames of whoever wants one until nobody does; a resting view gets all of its frames.
  std::vector<Work> show_all() {
    std::vector<Work> works;
    for (int i = 0; i < 100; ++i, pass(200))
      while (const auto work = take()) {
        show(*work);
        works.push_back(*work);
      }
    return works;
  }

  Time now{std::chrono::hours(1)};
  Metrics metrics;
  FrameScheduler scheduler{whole_frames(), metrics, [this] { return now; }};
};

}  // namespace cloudscape::stream
