// Exponential back-off with full jitter.
#include "viewer/back_off.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace cloudscape::viewer {

BackOff::BackOff(std::function<double()> uniform) : uniform_(std::move(uniform)) {}

double BackOff::next_s() {
  const double longest_s = std::min(most_s, std::ldexp(first_s, std::min(attempts_++, 30)));
  return least_s + uniform_() * (longest_s - least_s);
}

std::function<double()> random_uniform() {
  return [generator = std::mt19937(std::random_device{}())]() mutable {
    return std::uniform_real_distribution<double>(0.0, 1.0)(generator);
  };
}

}  // namespace cloudscape::viewer
