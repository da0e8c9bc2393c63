// The three colours of sun and air against the spectrum that they stand for.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>

#include "core/cloudscape_environment.h"
#include "unit/shaders/glsl.h"

namespace cloudscape {
namespace {

// From 360 nm on, every 10 nm: irradiance of the sun above the air (ASTM G-173), W/m2/nm, and cross section of ozone
// (Serdyuchenko et al. 2014, at 233 K), 1e-26 m2; both as means over 10 nm by Bruneton (2017).
constexpr std::array sun_w_per_m2_nm{
    1.11776, 1.14259, 1.01249, 1.14716, 1.72765, 1.73054, 1.6887,  1.61253, 1.91198, 2.03474, 2.02042, 2.02212,
    1.93377, 1.95809, 1.91686, 1.8298,  1.8685,  1.8931,  1.85149, 1.8504,  1.8341,  1.8345,  1.8147,  1.78158,
    1.7533,  1.6965,  1.68194, 1.64654, 1.6048,  1.52143, 1.55622, 1.5113,  1.474,   1.4482,  1.41018, 1.36775,
    1.34188, 1.31429, 1.28303, 1.26758, 1.2367,  1.2082,  1.18737, 1.14683, 1.12362, 1.1058,  1.07124, 1.04992};
constexpr std::array ozone_1e_26_m2{0.118, 0.0218, 0.0282, 0.0664, 0.153, 0.276, 0.552, 0.845, 1.58, 2.32, 3.67, 4.92,
                                    7.75,  9.02,   14.8,   16.0,   21.4,  27.6,  30.9,  35.0,  42.7, 46.7, 44.0, 47.0,
                                    50.2,  43.1,   37.4,   32.2,   26.6,  22.4,  18.5,  14.7,  12.1, 9.42, 7.46, 6.57,
                                    5.11,  4.15,   4.23,   3.24,   2.45,  2.80,  2.53,  1.62,  1.47, 2.08, 1.38, 0.711};

double lobe(double nm, double middle, double below, double above) {
  const double x = (nm - middle) / (nm < middle ? below : above);
  return std::exp(-0.5 * x * x);
}

// CIE 1931 colour matching functions, by the fit of Wyman, Sloan and Shirley (2013).
glm::dvec3 matching(double nm) {
  return {
      1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) - 0.065 * lobe(nm, 501.1, 20.4, 26.2),
      0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
      1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

// Of sunlight times `share`, of the wavelength's number; 1 W/m2/nm at all wavelengths has luminance 1.
glm::dvec3 linear_srgb(const std::function<double(std::size_t)>& share) {
  glm::dvec3 xyz(0);
  double white = 0;
  for (std::size_t i = 0; i < sun_w_per_m2_nm.size(); ++i) {
    const glm::dvec3 seen = matching(360 + 10 * static_cast<double>(i));
    xyz += sun_w_per_m2_nm[i] * share(i) * seen, white += seen.y;
  }
  xyz /= white;
  return {3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z, -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
          0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z};
}

// Hillaire's table at 550 nm, 1/m.
double rayleigh_per_m(std::size_t i) { return 13.558e-6 * std::pow(550 / (360.0 + 10 * static_cast<double>(i)), 4); }
double ozone_per_m(std::size_t i) { return 1.881e-6 * ozone_1e_26_m2[i] / ozone_1e_26_m2[19]; }

const glm::dvec3 sunlight = linear_srgb([](std::size_t) { return 1.0; });

TEST(Spectrum, TheSunHasTheColourOfSunlight) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(Sun{}.irradiance[c], sunlight[c], 0.002) << c;
}

TEST(Spectrum, AirScattersAndAbsorbsAsTheMeanOverTheSpectrum) {
  const glm::dvec3 rayleigh = linear_srgb(rayleigh_per_m) / sunlight, ozone = linear_srgb(ozone_per_m) / sunlight;
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(glsl::rayleigh_scattering_per_m()[c], rayleigh[c], 2e-8) << c;
    EXPECT_NEAR(glsl::ozone_absorption_per_m()[c], std::max<double>(0, ozone[c]), 1e-8) << c;
  }
}

// By how many times the air straight up light comes through: what is left has the spectrum's colour, down to the
// horizon.
TEST(Spectrum, SunlightReddensAsTheSpectrumDoes) {
  for (const double air_mass : {1.0, 3.0, 10.0, 30.0}) {
    const auto depth = [air_mass](double rayleigh, double ozone) {
      return air_mass * (rayleigh * 8000 + ozone * 15000);
    };
    const glm::dvec3 seen =
        linear_srgb([&](std::size_t i) { return std::exp(-depth(rayleigh_per_m(i), ozone_per_m(i))); }) / sunlight;
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(std::exp(-depth(glsl::rayleigh_scattering_per_m()[c], glsl::ozone_absorption_per_m()[c])), seen[c],
                  0.012)
          << c << " at " << air_mass;
  }
}

}  // namespace
}  // namespace cloudscape
