#include "bench/picture_error.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <random>

#include "bench/frame_times.h"
#include "bench/track_times.h"

namespace cloudscape::bench {
namespace {

double total(const glm::dvec3& rgb) { return rgb.x + rgb.y + rgb.z; }

}  // namespace

RadianceError radiance_error(const Picture& reference, const Picture& test, const Mask& counted) {
  std::vector<double> errors;
  double reference_sum = 0, test_sum = 0;
  for (std::size_t i = 0; i < reference.rgb.size(); ++i) {
    if (!counted[i] || total(reference.rgb[i]) <= 0) continue;
    errors.push_back(total(glm::abs(test.rgb[i] - reference.rgb[i])) / total(reference.rgb[i]));
    reference_sum += luminance(reference.rgb[i]);
    test_sum += luminance(test.rgb[i]);
  }
  if (errors.empty()) return {};
  return {mean_of(errors), spread_of(errors).p95_ms, std::log(test_sum / reference_sum), errors.size()};
}

double relative_noise(const Frame& traced, const Mask& counted) {
  std::vector<double> errors;
  const Picture picture = radiance_picture(traced);
  const std::vector<float>& error = traced.standard_error_rgb;
  for (std::size_t i = 0; i < picture.rgb.size() && 3 * i + 2 < error.size(); ++i)
    if (counted[i] && total(picture.rgb[i]) > 0)
      errors.push_back(total({error[3 * i], error[3 * i + 1], error[3 * i + 2]}) / total(picture.rgb[i]));
  return mean_of(errors);
}

Picture noisier(const Frame& traced) {
  Picture picture = radiance_picture(traced);
  const std::vector<float>& error = traced.standard_error_rgb;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < picture.rgb.size() && 3 * i + 2 < error.size(); ++i)
    for (int c = 0; c < 3; ++c)
      picture.rgb[i][c] = std::max(0.0, picture.rgb[i][c] + error[3 * i + c] * normal(random));
  return picture;
}

double psnr_db(const Picture& reference, const Picture& test) {
  double sum = 0;
  for (std::size_t i = 0; i < reference.rgb.size(); ++i) {
    const glm::dvec3 difference = test.rgb[i] - reference.rgb[i];
    sum += glm::dot(difference, difference);
  }
  const double mean_square = sum / (3 * static_cast<double>(reference.rgb.size()));
  return mean_square > 0 ? -10 * std::log10(mean_square) : 100;
}

}  // namespace cloudscape::bench
