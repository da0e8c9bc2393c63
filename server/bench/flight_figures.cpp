#include "bench/flight_figures.h"

#include <algorithm>

namespace cloudscape::bench {
namespace {

constexpr double median_tolerance = 1.05, p95_tolerance = 1.5;

std::vector<double> intervals_of(const std::vector<FlownFrame>& frames) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < frames.size(); ++i) intervals.push_back(frames[i].at_ms - frames[i - 1].at_ms);
  return intervals;
}

Spread spread_over(const std::vector<FlownFrame>& frames, double FlownFrame::*value) {
  std::vector<double> values;
  for (const FlownFrame& frame : frames) values.push_back(frame.*value);
  return spread_of(std::move(values));
}

int median_detail(std::vector<FlownFrame> frames) {
  if (frames.empty()) return 1;
  const auto middle = frames.begin() + static_cast<std::ptrdiff_t>(frames.size() / 2);
  std::nth_element(frames.begin(), middle, frames.end(),
                   [](const FlownFrame& a, const FlownFrame& b) { return a.detail < b.detail; });
  return middle->detail;
}

}  // namespace

std::vector<double> fps_of_seconds(const std::vector<FlownFrame>& frames, double seconds) {
  std::vector<double> counts(static_cast<std::size_t>(std::max(seconds, 0.0)), 0);
  for (const FlownFrame& frame : frames)
    if (const auto second = static_cast<std::size_t>(std::max(frame.at_ms, 0.0) / 1000); second < counts.size())
      ++counts[second];
  return counts;
}

FlightFigures figures_of(std::vector<FlownFrame> frames, double seconds) {
  std::ranges::sort(frames, {}, &FlownFrame::at_ms);
  FlightFigures figures;
  figures.frames = static_cast<int>(frames.size());
  figures.seconds = seconds;
  figures.fps_mean = seconds > 0 ? static_cast<double>(frames.size()) / seconds : 0;
  const std::vector<double> fps = fps_of_seconds(frames, seconds);
  figures.fps_median = fps.empty() ? figures.fps_mean : spread_of(fps).median_ms;
  figures.fps_least = fps.empty() ? figures.fps_mean : std::ranges::min(fps);
  figures.interval = spread_of(intervals_of(frames));
  figures.age = spread_over(frames, &FlownFrame::age_ms);
  figures.render = spread_over(frames, &FlownFrame::render_ms);
  figures.device = spread_over(frames, &FlownFrame::device_ms);
  figures.readback = spread_over(frames, &FlownFrame::readback_ms);
  figures.encode = spread_over(frames, &FlownFrame::encode_ms);
  for (const FlownFrame& frame : frames) figures.bytes += frame.bytes / static_cast<double>(frames.size());
  figures.detail = median_detail(frames);
  return figures;
}

bool holds(const FlightFigures& flight, double fps) {
  const double interval_ms = 1000 / fps;
  return flight.frames > 1 && flight.interval.median_ms <= median_tolerance * interval_ms &&
         flight.interval.p95_ms <= p95_tolerance * interval_ms;
}

}  // namespace cloudscape::bench
