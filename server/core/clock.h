// The time that clouds drift by: how it runs, and what is said of a clock and to it.
#pragma once
#include <algorithm>
#include <chrono>
#include <optional>

#include "core/fields.h"

namespace cloudscape {

// tuned: half a year either way, longer than any flight; a drift of 200 m/s stays exact to a micrometre in double.
constexpr double longest_time_s = 1.6e7;
constexpr Limits time_s_limits{-longest_time_s, longest_time_s};
constexpr Limits clock_rate_limits{-3600, 3600};  // tuned: a day in 24 s

// A time that runs, or stands; at its limits it stands.
struct RunningTime {
  using Instant = std::chrono::steady_clock::time_point;
  double time_s = 0;  // at `since`
  double rate = 0;    // seconds of it in a second
  Instant since{};
  bool operator==(const RunningTime&) const = default;

  double at(Instant now) const {
    const double passed_s = std::chrono::duration<double>(now - since).count();
    return std::clamp(time_s + rate * passed_s, -longest_time_s, longest_time_s);
  }
};

struct ClockState {
  double time_s = 0;
  double rate = 1;  // that it runs by where it is not paused
  bool paused = true;
  bool operator==(const ClockState&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("time_s", self.time_s, time_s_limits, "Time that it shows, s.");
    visit("rate", self.rate, clock_rate_limits, "Seconds of it in a second, where it is not paused.");
    visit("paused", self.paused, Limits{}, "Whether it stands.");
  }
};

// What is absent stays as it is.
struct ClockChange {
  std::optional<double> time_s, rate;
  std::optional<bool> paused;
  bool operator==(const ClockChange&) const = default;
};

}  // namespace cloudscape
