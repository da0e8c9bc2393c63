// Lorenz-Mie scattering by one homogeneous sphere (Bohren and Huffman 1983, chapter 4). Signs are those of Wiscombe
// 1979: the refractive index is n - ik with k >= 0.
#pragma once
#include <complex>
#include <vector>

namespace cloudscape::bake {

// Of the scattered wave's partial waves; index n - 1.
struct MieCoefficients {
  double size_parameter = 0;  // 2 pi radius / wavelength
  std::vector<std::complex<double>> a, b;
};
// `size_parameter` > 0. `index`: of the sphere relative to what surrounds it.
MieCoefficients mie_coefficients(double size_parameter, std::complex<double> index);

// How many partial waves a sphere needs: Wiscombe 1980 for 8 < x < 4200, and one more, for nine digits at all sizes.
int mie_order(double size_parameter);

struct MieEfficiencies {
  double extinction = 0, scattering = 0;  // cross-section over the sphere's shadow, pi radius^2
  double asymmetry_g = 0;                 // mean cosine of the scattering angle
  double backscattering = 0;              // 4 pi dQ/dOmega at 180 degrees, as radar has it
};
MieEfficiencies mie_efficiencies(const MieCoefficients& coefficients);

// Of the scattered wave, polarised across (s1) and along (s2) the plane of scattering.
struct MieAmplitudes {
  std::complex<double> s1, s2;
};
MieAmplitudes mie_amplitudes(const MieCoefficients& coefficients, double cos_theta);

}  // namespace cloudscape::bake
