// What a moving stream gave its viewer: the statistics of the frames that arrived.
#pragma once
#include <vector>

#include "bench/frame_times.h"

namespace cloudscape::bench {

struct FlownFrame {
  double at_ms = 0;   // when the viewer had it, since the measurement began
  double age_ms = 0;  // then, of the pose that it shows
  double render_ms = 0, device_ms = 0, readback_ms = 0, encode_ms = 0, bytes = 0;
  int detail = 0;  // of stream::moving_details
};

struct FlightFigures {
  int frames = 0;
  double seconds = 0;
  double fps_mean = 0, fps_median = 0, fps_least = 0;  // median and least: of whole seconds
  Spread interval, age, render, device, readback, encode;
  double bytes = 0;  // of a frame, mean
  int detail = 0;    // median
};
FlightFigures figures_of(std::vector<FlownFrame> frames, double seconds);

// Frames of each whole second.
std::vector<double> fps_of_seconds(const std::vector<FlownFrame>& frames, double seconds);

// Whether a viewer would say that it runs at so many frames a second: the median interval is one of `fps`, within 5 %
// (tuned: what poses sent 60 times a second leave open), and 95 % of the intervals are within 1.5 of one.
bool holds(const FlightFigures& flight, double fps);

}  // namespace cloudscape::bench
