// What the viewer measures of its stream: rates, latency, percentiles.
#pragma once
#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace cloudscape::viewer {

using Time = std::chrono::steady_clock::time_point;

double milliseconds_between(Time from, Time to);

// The smallest value that at least `percent` % of the values do not exceed (nearest rank); 0 of none.
double percentile(std::vector<double> values, double percent);

// From the moment a pose is sent to the moment its first frame is on display.
class LatencyMeter {
 public:
  void sent(std::uint64_t pose_sequence, Time time);
  // nullopt for a refinement of a pose that was already shown, and for frames before the first pose.
  std::optional<double> displayed(std::uint64_t pose_sequence, Time time);
  const std::vector<double>& all_ms() const { return all_ms_; }

 private:
  std::map<std::uint64_t, Time> waiting_;
  std::vector<double> all_ms_;
};

// Amount a second over the last second.
class RateMeter {
 public:
  void add(Time time, double amount);
  double per_second(Time now);

 private:
  std::deque<std::pair<Time, double>> recent_;
};

}  // namespace cloudscape::viewer
