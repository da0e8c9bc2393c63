// How long something takes.
#pragma once
#include <chrono>

namespace cloudscape {

inline double ms_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace cloudscape
