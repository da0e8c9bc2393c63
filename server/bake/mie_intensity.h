// Intensity that spheres scatter into many angles at once: the sum that takes nearly all the time of a phase function.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "bake/mie_sphere.h"

namespace cloudscape::bake {

// A sphere ready to be summed: (2n + 1) / (n (n + 1)) times a_n + b_n and a_n - b_n, n = 1, 2...
class SphereWaves {
 public:
  SphereWaves(const MieCoefficients& coefficients, double weight);
  struct Wave {
    double sum_re, sum_im, difference_re, difference_im;
  };
  std::vector<Wave> waves;
  double weight;  // of its intensity in the sum
};

// Adds weight (|S1|^2 + |S2|^2) / 2 of all spheres at each angle. Angles come in pairs theta and pi - theta: `mu` holds
// the cosines of the first ones, `front` and `back` are sums at the first and the second of each pair.
void add_intensities(std::span<const SphereWaves> spheres, std::span<const double> mu, std::span<double> front,
                     std::span<double> back);

}  // namespace cloudscape::bake
