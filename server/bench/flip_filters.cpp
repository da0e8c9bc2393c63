#include "bench/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cloudscape::bench {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double widest_b = 0.04;  // of all lobes: one radius for all channels
constexpr double detector_width_deg = 0.082;

double sum_of(const Kernel& kernel) {
  double sum = 0;
  for (const double weight : kernel) sum += weight;
  return sum;
}

template <class Weight>
Kernel kernel_of(int radius, const Weight& weight) {
  Kernel kernel;
  for (int x = -radius; x <= radius; ++x) kernel.push_back(weight(x));
  return kernel;
}

Kernel balanced(Kernel kernel) {
  double positive = 0, negative = 0;
  for (const double weight : kernel) (weight > 0 ? positive : negative) += std::abs(weight);
  for (double& weight : kernel)
    if (weight != 0) weight /= weight > 0 ? positive : negative;
  return kernel;
}

// Along one axis: `step` from a pixel to its neighbour, `length` pixels from border to border.
void filter_line(const double* from, double* to, int length, std::ptrdiff_t step, const Kernel& kernel) {
  const int radius = static_cast<int>(kernel.size() / 2);
  for (int i = 0; i < length; ++i) {
    double sum = 0;
    for (int k = -radius; k <= radius; ++k) sum += kernel[k + radius] * from[std::clamp(i + k, 0, length - 1) * step];
    to[i * step] = sum;
  }
}

}  // namespace

Plane filtered(const Plane& plane, const ImageSize& size_px, const Kernel& along_x, const Kernel& along_y) {
  const auto [width, height] = size_px;
  Plane rows(plane.size()), result(plane.size());
  for (int y = 0; y < height; ++y)
    filter_line(&plane[std::size_t(y) * width], &rows[std::size_t(y) * width], width, 1, along_x);
  for (int x = 0; x < width; ++x) filter_line(&rows[x], &result[x], height, width, along_y);
  return result;
}

Plane blurred(const Plane& plane, const ImageSize& size_px, std::span<const SensitivityLobe> lobes,
              double pixels_per_degree) {
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(widest_b / (2 * pi * pi)) * pixels_per_degree));
  Plane result(plane.size());
  double total = 0;
  for (const SensitivityLobe& lobe : lobes) {
    const Kernel kernel = kernel_of(radius, [&](int x) {
      const double x_deg = x / pixels_per_degree;
      return std::exp(-pi * pi * x_deg * x_deg / lobe.b);
    });
    const double amplitude = lobe.a * std::sqrt(pi / lobe.b);
    total += amplitude * sum_of(kernel) * sum_of(kernel);
    const Plane part = filtered(plane, size_px, kernel, kernel);
    for (std::size_t i = 0; i < part.size(); ++i) result[i] += amplitude * part[i];
  }
  for (double& value : result) value /= total;
  return result;
}

FeatureKernels feature_kernels(double pixels_per_degree) {
  const double deviation = 0.5 * detector_width_deg * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * deviation));
  const auto gaussian = [&](int x) { return std::exp(-x * x / (2 * deviation * deviation)); };
  return {balanced(kernel_of(radius, gaussian)), balanced(kernel_of(radius, [&](int x) { return -x * gaussian(x); })),
          balanced(kernel_of(radius, [&](int x) { return (x * x / (deviation * deviation) - 1) * gaussian(x); }))};
}

}  // namespace cloudscape::bench
