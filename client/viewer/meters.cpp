// Rates, latency, percentiles.
#include "viewer/meters.h"

#include <algorithm>
#include <cmath>

namespace cloudscape::viewer {

double milliseconds_between(Time from, Time to) { return std::chrono::duration<double, std::milli>(to - from).count(); }

double percentile(std::vector<double> values, double percent) {
  if (values.empty()) return 0.0;
  const double rank = std::ceil(percent / 100.0 * static_cast<double>(values.size()));
  const auto index = static_cast<std::size_t>(std::clamp(rank, 1.0, static_cast<double>(values.size()))) - 1;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(index), values.end());
  return values[index];
}

void LatencyMeter::sent(std::uint64_t pose_sequence, Time time) { waiting_.emplace(pose_sequence, time); }

std::optional<double> LatencyMeter::displayed(std::uint64_t pose_sequence, Time time) {
  const auto pose = waiting_.find(pose_sequence);
  if (pose == waiting_.end()) return std::nullopt;
  const double latency_ms = milliseconds_between(pose->second, time);
  waiting_.erase(waiting_.begin(), std::next(pose));  // the server skipped the older ones: the newest pose wins
  all_ms_.push_back(latency_ms);
  return latency_ms;
}

void RateMeter::add(Time time, double amount) { recent_.emplace_back(time, amount); }

double RateMeter::per_second(Time now) {
  while (!recent_.empty() && now - recent_.front().first >= std::chrono::seconds(1)) recent_.pop_front();
  double sum = 0;
  for (const auto& [time, amount] : recent_) sum += amount;
  return sum;
}

}  // namespace cloudscape::viewer
