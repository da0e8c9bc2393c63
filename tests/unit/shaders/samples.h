// Where functions of shaders/lib are tried, and integrals and maxima to compare them with.
#pragma once
#include <cmath>
#include <glm/glm.hpp>
#include <random>

namespace cloudscape {

class Samples {
 public:
  float between(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random_); }
  glm::vec3 in_box(glm::vec3 low, glm::vec3 high) {
    return {between(low.x, high.x), between(low.y, high.y), between(low.z, high.z)};
  }
  glm::vec3 direction() {
    const float z = between(-1, 1), azimuth = between(0, 6.2831853F), side = std::sqrt(1 - z * z);
    return {side * std::cos(azimuth), side * std::sin(azimuth), z};
  }

 private:
  std::mt19937 random_{20021};
};

// Simpson's rule.
template <class Function>
long double integral(Function function, long double low, long double high, int pairs) {
  const long double step = (high - low) / (2 * pairs);
  long double sum = 0;
  for (int i = 0; i <= 2 * pairs; ++i) {
    const int weight = i == 0 || i == 2 * pairs ? 1 : (i % 2 == 1 ? 4 : 2);
    sum += weight * static_cast<long double>(function(low + step * i));
  }
  return sum * step / 3;
}

// The greatest value on a fine grid.
template <class Function>
double greatest(Function function, double low, double high, int points) {
  double best = function(low);
  for (int i = 1; i <= points; ++i) best = std::max<double>(best, function(low + (high - low) * i / points));
  return best;
}

}  // namespace cloudscape
