#include "bake/mie_sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cloudscape::bake {
namespace {

using Complex = std::complex<double>;

// A downward recurrence forgets its start within some orders above |z|; Bohren and Huffman's 16 (appendix A) are too
// few where |z| is large: the functions begin to decay over a width of |z|^(1/3) orders.
int start_above(double z) { return static_cast<int>(z + 8 * std::cbrt(z)) + 16; }

// D_n = psi_n' / psi_n at z = m x, index n; downward, which is the stable direction.
std::vector<Complex> logarithmic_derivatives(Complex z, int order) {
  const int start = std::max(order + 16, start_above(std::abs(z)));
  std::vector<Complex> derivatives(static_cast<std::size_t>(order) + 1);
  Complex derivative = 0;
  for (int n = start; n > 0; --n) {
    const Complex ratio = static_cast<double>(n) / z;
    derivative = ratio - 1.0 / (derivative + ratio);
    if (n - 1 <= order) derivatives[static_cast<std::size_t>(n) - 1] = derivative;
  }
  return derivatives;
}

// psi_n / psi_(n-1) from n = first on; downward, where upward would lose all digits. Index n - first.
std::vector<double> bessel_ratios(double x, int first, int order) {
  std::vector<double> ratios(static_cast<std::size_t>(std::max(0, order - first + 1)));
  double ratio = 0;
  for (int n = start_above(x); n >= first; --n) {
    ratio = 1 / ((2 * n + 1) / x - ratio);
    if (n <= order) ratios[static_cast<std::size_t>(n - first)] = ratio;
  }
  return ratios;
}

// The Riccati-Bessel functions psi_0.. and chi_0.. up to the order.
struct RiccatiBessel {
  std::vector<double> psi, chi;
};
RiccatiBessel riccati_bessel(double x, int order) {
  const auto size = static_cast<std::size_t>(order) + 1;
  RiccatiBessel functions{std::vector<double>(size), std::vector<double>(size)};
  const int turn = std::max(1, static_cast<int>(x));  // psi oscillates below it and decays above
  const std::vector<double> ratios = bessel_ratios(x, turn, order);
  double psi_before = std::cos(x), chi_before = -std::sin(x);
  functions.psi[0] = std::sin(x), functions.chi[0] = std::cos(x);
  for (int n = 1; n <= order; ++n) {
    const auto i = static_cast<std::size_t>(n);
    const double factor = (2 * n - 1) / x;
    const double psi = functions.psi[i - 1], chi = functions.chi[i - 1];
    functions.psi[i] = n < turn ? factor * psi - psi_before : psi * ratios[static_cast<std::size_t>(n - turn)];
    functions.chi[i] = factor * chi - chi_before;
    psi_before = psi, chi_before = chi;
  }
  return functions;
}

double times_conjugate(Complex left, Complex right) { return left.real() * right.real() + left.imag() * right.imag(); }

// The angular functions of order n, of the cosine of the scattering angle.
struct AngularFunctions {
  explicit AngularFunctions(double cos_theta) : mu(cos_theta) {}
  double mu, pi = 1, pi_before = 0;
  int n = 1;
  double tau() const { return n * mu * pi - (n + 1) * pi_before; }
  void next() {
    const double pi_next = ((2 * n + 1) * mu * pi - (n + 1) * pi_before) / n;
    pi_before = pi, pi = pi_next, ++n;
  }
};

}  // namespace

int mie_order(double size_parameter) { return static_cast<int>(size_parameter + 4.05 * std::cbrt(size_parameter) + 3); }

// Bohren and Huffman, equation 4.88.
MieCoefficients mie_coefficients(double size_parameter, Complex index) {
  const int order = mie_order(size_parameter);
  const auto derivatives = logarithmic_derivatives(size_parameter * index, order);
  const RiccatiBessel functions = riccati_bessel(size_parameter, order);
  MieCoefficients coefficients{size_parameter, {}, {}};
  coefficients.a.reserve(static_cast<std::size_t>(order));
  coefficients.b.reserve(static_cast<std::size_t>(order));
  for (std::size_t n = 1; n <= static_cast<std::size_t>(order); ++n) {
    const double psi = functions.psi[n], psi_before = functions.psi[n - 1];
    const Complex xi{psi, functions.chi[n]}, xi_before{psi_before, functions.chi[n - 1]};
    const double curvature = static_cast<double>(n) / size_parameter;
    const Complex electric = derivatives[n] / index + curvature, magnetic = derivatives[n] * index + curvature;
    coefficients.a.push_back((electric * psi - psi_before) / (electric * xi - xi_before));
    coefficients.b.push_back((magnetic * psi - psi_before) / (magnetic * xi - xi_before));
  }
  return coefficients;
}

// Bohren and Huffman, equations 4.61, 4.62 and section 4.5.
MieEfficiencies mie_efficiencies(const MieCoefficients& coefficients) {
  const auto& [x, a, b] = coefficients;
  double extinction = 0, scattering = 0, cosine = 0;
  Complex back = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double n = static_cast<double>(i) + 1;
    extinction += (2 * n + 1) * (a[i] + b[i]).real();
    scattering += (2 * n + 1) * (std::norm(a[i]) + std::norm(b[i]));
    cosine += (2 * n + 1) / (n * (n + 1)) * times_conjugate(a[i], b[i]);
    if (i + 1 < a.size())
      cosine += n * (n + 2) / (n + 1) * (times_conjugate(a[i], a[i + 1]) + times_conjugate(b[i], b[i + 1]));
    back += (i % 2 == 0 ? -1.0 : 1.0) * (2 * n + 1) * (a[i] - b[i]);
  }
  const double scale = 2 / (x * x);
  return {scale * extinction, scale * scattering, 2 * cosine / scattering, std::norm(back) / (x * x)};
}

// Bohren and Huffman, equation 4.74.
MieAmplitudes mie_amplitudes(const MieCoefficients& coefficients, double cos_theta) {
  MieAmplitudes sum;
  AngularFunctions angle(cos_theta);
  for (std::size_t i = 0; i < coefficients.a.size(); ++i, angle.next()) {
    const double weight = (2.0 * angle.n + 1) / (static_cast<double>(angle.n) * (angle.n + 1));
    sum.s1 += weight * (coefficients.a[i] * angle.pi + coefficients.b[i] * angle.tau());
    sum.s2 += weight * (coefficients.a[i] * angle.tau() + coefficients.b[i] * angle.pi);
  }
  return sum;
}

}  // namespace cloudscape::bake
