// Durations as the milliseconds that timings and metrics carry.
#pragma once
#include <chrono>
#include <cmath>

namespace cloudscape {

constexpr double milliseconds(std::chrono::steady_clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

inline double ms_since(std::chrono::steady_clock::time_point start) {
  return milliseconds(std::chrono::steady_clock::now() - start);
}

// A duration that others measured; a viewer may send anything.
inline double plausible_ms(double value_ms) { return std::isfinite(value_ms) && value_ms > 0 ? value_ms : 0; }

}  // namespace cloudscape
