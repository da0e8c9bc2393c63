#include "bench/flip.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "bench/flip_color.h"
#include "bench/flip_filters.h"

namespace cloudscape::bench {
namespace {

// Andersson et al. 2020: exponents of the colour and the feature difference; p_c of the greatest colour difference is
// mapped to p_t.
constexpr double color_exponent = 0.7, feature_exponent = 0.5, p_c = 0.4, p_t = 0.95;
// Their table 1: contrast sensitivities, achromatic, red-green, blue-yellow.
constexpr SensitivityLobe achromatic[] = {{1, 0.0047}}, red_green[] = {{1, 0.0053}},
                          blue_yellow[] = {{34.1, 0.04}, {13.5, 0.025}};

struct Opponent {
  Plane y, cx, cz;
};

Opponent opponent_of(const Picture& display) {
  Opponent planes;
  for (const glm::dvec3& rgb : display.rgb) {
    const glm::dvec3 opponent = opponent_from_linear(linear_from_srgb(rgb));
    planes.y.push_back(opponent.x), planes.cx.push_back(opponent.y), planes.cz.push_back(opponent.z);
  }
  return planes;
}

// What the eye sees of the colours.
std::vector<glm::dvec3> seen_colors(const Opponent& planes, const ImageSize& size_px, double pixels_per_degree) {
  const Plane y = blurred(planes.y, size_px, achromatic, pixels_per_degree);
  const Plane cx = blurred(planes.cx, size_px, red_green, pixels_per_degree);
  const Plane cz = blurred(planes.cz, size_px, blue_yellow, pixels_per_degree);
  std::vector<glm::dvec3> colors;
  for (std::size_t i = 0; i < y.size(); ++i)
    colors.push_back(hunt_lab_from_linear(glm::clamp(linear_from_opponent({y[i], cx[i], cz[i]}), 0.0, 1.0)));
  return colors;
}

double color_difference(const glm::dvec3& a, const glm::dvec3& b) {
  static const double most =
      std::pow(hyab(hunt_lab_from_linear({0, 1, 0}), hunt_lab_from_linear({0, 0, 1})), color_exponent);
  const double difference = std::pow(hyab(a, b), color_exponent), knee = p_c * most;
  return difference < knee ? p_t * difference / knee : p_t + (1 - p_t) * (difference - knee) / (most - knee);
}

struct Features {
  Plane edges, points;  // how strong
};

Plane length_of(const Plane& a, const Plane& b) {
  Plane lengths(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) lengths[i] = std::hypot(a[i], b[i]);
  return lengths;
}

Features features_of(const Opponent& planes, const ImageSize& size_px, double pixels_per_degree) {
  Plane lightness = planes.y;
  for (double& value : lightness) value = (value + 16) / 116;
  const auto [gaussian, slope, curvature] = feature_kernels(pixels_per_degree);
  const auto strength = [&](const Kernel& kernel) {
    return length_of(filtered(lightness, size_px, kernel, gaussian), filtered(lightness, size_px, gaussian, kernel));
  };
  return {strength(slope), strength(curvature)};
}

double feature_difference(const Features& a, const Features& b, std::size_t i) {
  const double more = std::max(std::abs(a.edges[i] - b.edges[i]), std::abs(a.points[i] - b.points[i]));
  return std::pow(more / std::sqrt(2.0), feature_exponent);
}

// The curve that HDR-FLIP assumes (Narkowicz's fit of ACES, its factor of 0.6 taken out), of one channel.
struct Rational {
  double n2 = 0.36 * 2.51, n1 = 0.6 * 0.03, d2 = 0.36 * 2.43, d1 = 0.6 * 0.59, d0 = 0.14;
  double operator()(double x) const { return std::clamp((n2 * x + n1) * x / ((d2 * x + d1) * x + d0), 0.0, 1.0); }
  // Where it is t: the positive root of (n2 - t d2) x^2 + (n1 - t d1) x - t d0 = 0.
  double inverse(double t) const {
    const double a = n2 - t * d2, half_b = (n1 - t * d1) / 2, c = -t * d0;
    return (-half_b + std::sqrt(half_b * half_b - a * c)) / a;
  }
};

Picture exposed(const Picture& radiance, double exposure_ev) {
  constexpr double brightest = 1e6;  // after exposure: white long since, and its square finite
  const Rational curve;
  const double exposure = std::exp2(exposure_ev);
  Picture display{radiance.size_px, {}};
  for (const glm::dvec3& rgb : radiance.rgb) {
    const glm::dvec3 x = glm::clamp(rgb * exposure, 0.0, brightest);
    display.rgb.push_back(srgb_from_linear({curve(x.x), curve(x.y), curve(x.z)}));
  }
  return display;
}

}  // namespace

std::vector<double> ldr_flip(const Picture& reference, const Picture& test, double pixels_per_degree) {
  const ImageSize& size_px = reference.size_px;
  const Opponent a = opponent_of(reference), b = opponent_of(test);
  const auto colors_a = seen_colors(a, size_px, pixels_per_degree),
             colors_b = seen_colors(b, size_px, pixels_per_degree);
  const Features features_a = features_of(a, size_px, pixels_per_degree);
  const Features features_b = features_of(b, size_px, pixels_per_degree);
  std::vector<double> errors;
  for (std::size_t i = 0; i < colors_a.size(); ++i)
    errors.push_back(std::pow(color_difference(colors_a[i], colors_b[i]),  // 0^x is 0: same colours, no difference
                              1 - feature_difference(features_a, features_b, i)));
  return errors;
}

ExposureRange exposure_range(const Picture& reference) {
  std::vector<double> values;
  for (const glm::dvec3& rgb : reference.rgb) values.push_back(luminance(rgb));
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  const double median = values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
  if (values.back() <= 0 || median <= 0) return {};  // mostly black: as it is
  const double target = Rational{}.inverse(0.85);
  ExposureRange range{std::log2(target / values.back()), std::log2(target / median), 2};
  range.count = std::max(2, static_cast<int>(std::ceil(range.stop_ev - range.start_ev)));
  return range;
}

std::vector<double> hdr_flip(const Picture& reference, const Picture& test, double pixels_per_degree) {
  const ExposureRange range = exposure_range(reference);
  std::vector<double> worst(reference.rgb.size());
  for (int i = 0; i < range.count; ++i) {
    const double exposure_ev = range.exposure_ev(i);
    const auto errors = ldr_flip(exposed(reference, exposure_ev), exposed(test, exposure_ev), pixels_per_degree);
    for (std::size_t pixel = 0; pixel < worst.size(); ++pixel) worst[pixel] = std::max(worst[pixel], errors[pixel]);
  }
  return worst;
}

}  // namespace cloudscape::bench
