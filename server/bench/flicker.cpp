#include "bench/flicker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/frame_times.h"
#include "bench/track_times.h"

namespace cloudscape::bench {

void Flicker::add(const Picture& shown, const Picture& truth) {
  Lumas difference;
  difference.reserve(shown.rgb.size());
  for (std::size_t i = 0; i < shown.rgb.size(); ++i) difference.push_back(luminance(shown.rgb[i] - truth.rgb[i]));
  add(std::move(difference));
}

void Flicker::add(const Picture& shown) {
  Lumas lumas;
  lumas.reserve(shown.rgb.size());
  for (const glm::dvec3& rgb : shown.rgb) lumas.push_back(luminance(rgb));
  add(std::move(lumas));
}

void Flicker::add(Lumas difference) {
  sum_of_squares_.resize(difference.size());
  if (++frames_ > 2) {
    for (std::size_t i = 0; i < difference.size(); ++i) {
      const double h = last_[i] - (before_last_[i] + difference[i]) / 2;
      sum_of_squares_[i] += h * h / 1.5;
    }
  }
  before_last_ = std::exchange(last_, std::move(difference));
}

FlickerFigure Flicker::figure() const {
  if (frames_ < 3) return {0, 0, frames_};
  std::vector<double> percents;
  for (const double sum : sum_of_squares_) percents.push_back(100 * std::sqrt(sum / (frames_ - 2)));
  const double mean = mean_of(percents);
  const auto p99 = percents.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(percents.size()));
  std::nth_element(percents.begin(), p99, percents.end());
  return {mean, *p99, frames_};
}

}  // namespace cloudscape::bench
