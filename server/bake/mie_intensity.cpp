#include "bake/mie_intensity.h"

#include <algorithm>
#include <array>

namespace cloudscape::bake {
namespace {

constexpr std::size_t lanes = 8;  // angles that are summed side by side, for the compiler's vectors
using Lanes = std::array<double, lanes>;

// pi_n + tau_n and pi_n - tau_n of some angles, n = 1, 2... At pi - theta they change places, and signs.
struct AngularFunctions {
  std::vector<Lanes> sum, difference;
};

AngularFunctions angular_functions(const Lanes& mu, std::size_t order) {
  AngularFunctions functions{std::vector<Lanes>(order), std::vector<Lanes>(order)};
  Lanes pi, pi_before{};
  pi.fill(1);
  for (std::size_t i = 0; i < order; ++i) {
    const double n = static_cast<double>(i) + 1;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const double tau = n * mu[lane] * pi[lane] - (n + 1) * pi_before[lane];
      functions.sum[i][lane] = pi[lane] + tau;
      functions.difference[i][lane] = pi[lane] - tau;
      const double next = ((2 * n + 1) * mu[lane] * pi[lane] - (n + 1) * pi_before[lane]) / n;
      pi_before[lane] = pi[lane];
      pi[lane] = next;
    }
  }
  return functions;
}

// A complex sum for each angle.
struct Amplitude {
  Lanes re{}, im{};
  void add(double wave_re, double wave_im, const Lanes& angular) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      re[lane] += wave_re * angular[lane];
      im[lane] += wave_im * angular[lane];
    }
  }
  double norm(std::size_t lane) const { return re[lane] * re[lane] + im[lane] * im[lane]; }
};

// S1 + S2 and S1 - S2, which have no cross terms (Wiscombe 1980): |S1|^2 + |S2|^2 is half the sum of their squares.
void add_intensity(const SphereWaves& sphere, const AngularFunctions& functions, Lanes& front, Lanes& back) {
  Amplitude front_sum, front_difference, back_sum, back_difference;
  double sign = 1;
  for (std::size_t i = 0; i < sphere.waves.size(); ++i, sign = -sign) {
    const SphereWaves::Wave& wave = sphere.waves[i];
    front_sum.add(wave.sum_re, wave.sum_im, functions.sum[i]);
    front_difference.add(wave.difference_re, wave.difference_im, functions.difference[i]);
    back_sum.add(sign * wave.sum_re, sign * wave.sum_im, functions.difference[i]);
    back_difference.add(sign * wave.difference_re, sign * wave.difference_im, functions.sum[i]);
  }
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    front[lane] += 0.25 * sphere.weight * (front_sum.norm(lane) + front_difference.norm(lane));
    back[lane] += 0.25 * sphere.weight * (back_sum.norm(lane) + back_difference.norm(lane));
  }
}

}  // namespace

SphereWaves::SphereWaves(const MieCoefficients& coefficients, double weight_in_sum) : weight(weight_in_sum) {
  waves.reserve(coefficients.a.size());
  for (std::size_t i = 0; i < coefficients.a.size(); ++i) {
    const double n = static_cast<double>(i) + 1;
    const double scale = (2 * n + 1) / (n * (n + 1));
    const std::complex<double> sum = scale * (coefficients.a[i] + coefficients.b[i]);
    const std::complex<double> difference = scale * (coefficients.a[i] - coefficients.b[i]);
    waves.push_back({sum.real(), sum.imag(), difference.real(), difference.imag()});
  }
}

void add_intensities(std::span<const SphereWaves> spheres, std::span<const double> mu, std::span<double> front,
                     std::span<double> back) {
  std::size_t order = 0;
  for (const SphereWaves& sphere : spheres) order = std::max(order, sphere.waves.size());
  for (std::size_t first = 0; first < mu.size(); first += lanes) {
    const std::size_t count = std::min(lanes, mu.size() - first);
    Lanes mu_lanes{}, front_lanes{}, back_lanes{};
    std::copy_n(mu.begin() + static_cast<std::ptrdiff_t>(first), count, mu_lanes.begin());
    const AngularFunctions functions = angular_functions(mu_lanes, order);
    for (const SphereWaves& sphere : spheres) add_intensity(sphere, functions, front_lanes, back_lanes);
    for (std::size_t lane = 0; lane < count; ++lane) {
      front[first + lane] += front_lanes[lane];
      back[first + lane] += back_lanes[lane];
    }
  }
}

}  // namespace cloudscape::bake
