// One sphere against the published test cases: Wiscombe 1979 (NCAR TN-140), Bohren and Huffman 1983, appendix A.
#include "bake/mie_sphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cloudscape::bake {
namespace {

using Complex = std::complex<double>;

struct Case {
  Complex index;
  double size_parameter, extinction, scattering, asymmetry_g;
};

// One unit of the last digit that is printed: it was computed with 32 bits.
constexpr double six_digits = 1e-6;

TEST(MieSphere, MeetsWiscombesEfficiencies) {
  const Case cases[] = {
      {{1.33, -1e-5}, 1, 0.093952, 0.093923, 0.184517},     {{1.33, -1e-5}, 100, 2.101321, 2.096594, 0.868959},
      {{1.33, -1e-5}, 10000, 2.004089, 1.723857, 0.907840}, {{0.75, 0}, 10, 2.232265, 2.232265, 0.896473},
      {{0.75, 0}, 1000, 1.997908, 1.997908, 0.844944},      {{1.5, -1}, 1, 2.336321, 0.663454, 0.192136},
      {{1.5, -1}, 100, 2.097502, 1.283697, 0.850252},       {{1.5, -1}, 10000, 2.004368, 1.236575, 0.846309},
      {{10, -10}, 1, 2.532993, 2.049405, -0.110664},        {{10, -10}, 100, 2.071124, 1.836785, 0.556215},
      {{10, -10}, 10000, 2.005914, 1.795393, 0.548194}};
  for (const Case& known : cases) {
    const MieEfficiencies found = mie_efficiencies(mie_coefficients(known.size_parameter, known.index));
    EXPECT_NEAR(found.extinction, known.extinction, six_digits) << known.index << known.size_parameter;
    EXPECT_NEAR(found.scattering, known.scattering, six_digits) << known.index << known.size_parameter;
    EXPECT_NEAR(found.asymmetry_g, known.asymmetry_g, six_digits) << known.index << known.size_parameter;
  }
}

TEST(MieSphere, MeetsWiscombesEfficienciesOfGlassThatAbsorbsNothing) {
  const double cases[][2] = {{10, 2.8820}, {100, 2.0944}, {1000, 2.0139}, {5000, 2.0086}};
  for (const auto& [size_parameter, extinction] : cases) {
    const MieEfficiencies found = mie_efficiencies(mie_coefficients(size_parameter, 1.5));
    EXPECT_NEAR(found.extinction, extinction, 0.51e-4) << size_parameter;
    EXPECT_NEAR(found.scattering, found.extinction, 1e-9) << size_parameter;
  }
}

TEST(MieSphere, MeetsThePublishedBackscattering) {
  struct {
    Complex index;
    double size_parameter, extinction, scattering, asymmetry_g, back, tolerance;
  } const cases[] = {
      {1.55, 2 * std::numbers::pi * 0.525 / 0.6328, 3.10543, 3.10543, 0.63314, 2.92534, 0.51e-5},
      {{1.55, -0.1}, 2 * std::numbers::pi * 0.525 / 0.6328, 2.86165188, 1.66424912, 0.80128973, 0.20599534, 0.51e-8},
      {{1.5, -0.5}, 2.5, 2.562873497, 1.097071819, 0.748905979, 0.123586468, 0.51e-9}};
  for (const auto& known : cases) {
    const MieEfficiencies found = mie_efficiencies(mie_coefficients(known.size_parameter, known.index));
    EXPECT_NEAR(found.extinction, known.extinction, known.tolerance) << known.index;
    EXPECT_NEAR(found.scattering, known.scattering, known.tolerance) << known.index;
    EXPECT_NEAR(found.asymmetry_g, known.asymmetry_g, known.tolerance) << known.index;
    EXPECT_NEAR(found.backscattering, known.back, known.tolerance) << known.index;
  }
}

void expect_near(Complex found, Complex known, double tolerance) {
  EXPECT_NEAR(found.real(), known.real(), tolerance);
  EXPECT_NEAR(found.imag(), known.imag(), tolerance);
}

TEST(MieSphere, MeetsWiscombesAmplitudes) {
  const MieCoefficients dark = mie_coefficients(1, {1.5, -1});
  expect_near(mie_amplitudes(dark, 1).s1, {0.584080, 0.190515}, six_digits);
  expect_near(mie_amplitudes(dark, 1).s2, {0.584080, 0.190515}, six_digits);
  expect_near(mie_amplitudes(dark, 0).s1, {0.456340, 0.167167}, six_digits);
  expect_near(mie_amplitudes(dark, 0).s2, {0.036228, -0.061826}, six_digits);
  expect_near(mie_amplitudes(dark, -1).s1, {0.348844, 0.146829}, six_digits);
  expect_near(mie_amplitudes(dark, -1).s2, {-0.348844, -0.146829}, six_digits);
  expect_near(mie_amplitudes(mie_coefficients(10, 1.5), -1).s1, {4.3216, 4.8683}, 0.51e-4);
  expect_near(mie_amplitudes(mie_coefficients(10, 0.75), 1).s1, {55.80662, -9.75810}, 0.51e-5);
}

TEST(MieSphere, MeetsBohrenAndHuffmansIntensityAndPolarisation) {
  const MieCoefficients sphere = mie_coefficients(2 * std::numbers::pi * 0.525 / 0.6328, 1.55);
  const auto intensity = [&](double angle_deg) {
    const MieAmplitudes at = mie_amplitudes(sphere, std::cos(angle_deg * std::numbers::pi / 180));
    return (std::norm(at.s1) + std::norm(at.s2)) / 2;
  };
  const double known[][2] = {{9, .785390},   {18, .356897},  {27, .0766119}, {36, .0355355},
                             {45, .0701845}, {90, .0124601}, {180, .0383189}};
  for (const auto& [angle_deg, ratio] : known)
    EXPECT_NEAR(intensity(angle_deg) / intensity(0), ratio, 0.51e-5 * ratio / 0.1) << angle_deg;
  const double polarisation[][2] = {{9, -.0045981}, {18, -.0458541}, {27, -.3647445}};
  for (const auto& [angle_deg, known_polarisation] : polarisation) {
    const MieAmplitudes at = mie_amplitudes(sphere, std::cos(angle_deg * std::numbers::pi / 180));
    const double across = std::norm(at.s1), along = std::norm(at.s2);
    EXPECT_NEAR((across - along) / (along + across), known_polarisation, 1e-6) << angle_deg;
  }
}

// Rayleigh 1871, in the words of Bohren and Huffman, section 5.1: the limit of small spheres.
TEST(MieSphere, SmallSpheresScatterAsRayleighSays) {
  const Complex index(1.33, -1e-4);
  const double x = 0.01;
  const Complex polarisability = (index * index - 1.0) / (index * index + 2.0);
  const MieCoefficients sphere = mie_coefficients(x, index);
  const MieEfficiencies found = mie_efficiencies(sphere);
  EXPECT_NEAR(found.scattering / (8.0 / 3 * std::pow(x, 4) * std::norm(polarisability)), 1, 1e-3);
  EXPECT_NEAR((found.extinction - found.scattering) / (-4 * x * polarisability.imag()), 1, 1e-3);
  EXPECT_NEAR(found.asymmetry_g, 0, 1e-4);
  for (const double mu : {-1.0, -0.3, 0.0, 0.8}) {
    const MieAmplitudes at = mie_amplitudes(sphere, mu), forward = mie_amplitudes(sphere, 1);
    EXPECT_NEAR(std::norm(at.s1) / std::norm(forward.s1), 1, 1e-3) << mu;
    EXPECT_NEAR(std::norm(at.s2) / std::norm(forward.s1), mu * mu, 1e-3) << mu;
  }
}

// Where nothing is absorbed what is taken from the beam is what is scattered, at any size; and the forward amplitude
// says both (the optical theorem).
TEST(MieSphere, KeepsEnergyAndTheOpticalTheorem) {
  for (const double x : {0.1, 1.0, 7.9, 8.1, 33.3, 420.0, 4199.0, 4201.0}) {
    const MieCoefficients sphere = mie_coefficients(x, 1.333);
    const MieEfficiencies found = mie_efficiencies(sphere);
    EXPECT_NEAR(found.scattering / found.extinction, 1, 1e-8) << x;
    EXPECT_NEAR(4 * mie_amplitudes(sphere, 1).s1.real() / (x * x * found.extinction), 1, 1e-10) << x;
  }
}

}  // namespace
}  // namespace cloudscape::bake
