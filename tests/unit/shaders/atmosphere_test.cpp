// The clear atmosphere against closed forms, and against values of an independent integration.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/shaders/glsl.h"
#include "unit/shaders/samples.h"

namespace cloudscape {
namespace {

using glsl::transmittance_to_space, glsl::vec3;

constexpr int fine = 500;
constexpr int tabulated = 48;  // as the transmittance table is made
double sine(double degrees) { return std::sin(degrees * 3.141592653589793238L / 180); }

// Up, the integral of each density is known: H (1 - exp(-100 km / H)), and 15 km of ozone.
TEST(TransmittanceToSpace, MeetsTheClosedFormStraightUp) {
  const double rayleigh_m = 8000 * (1 - std::exp(-12.5)), aerosol_m = 1200;
  const vec3 clear = transmittance_to_space(0, 1, 0, fine), hazy = transmittance_to_space(0, 1, 3, fine);
  const double rayleigh[] = {5.802e-6L, 13.558e-6L, 33.1e-6L}, ozone[] = {0.650e-6L, 1.881e-6L, 0.085e-6L};
  for (int i = 0; i < 3; ++i) {
    const double depth = rayleigh[i] * rayleigh_m + ozone[i] * 15000;
    EXPECT_NEAR(clear[i], std::exp(-depth), 1e-4);
    EXPECT_NEAR(hazy[i], std::exp(-depth - 3 * 4.44e-6L * aerosol_m), 1e-4);
  }
}

struct Row {
  double elevation_deg;
  std::array<double, 3> transmittance;
};
// From sea level, of an integration in double precision that is not ours.
const Row table[] = {{90, {0.940359L, 0.867616L, 0.762310L}},
                     {30, {0.884784L, 0.753858L, 0.582282L}},
                     {10, {0.712941L, 0.459379L, 0.221627L}},
                     {5, {0.543644L, 0.249466L, 0.063628L}}};

TEST(TransmittanceToSpace, MeetsAnIndependentIntegration) {
  for (const Row& row : table)
    for (std::size_t i = 0; i < 3; ++i) {
      const float mu = sine(row.elevation_deg);
      EXPECT_NEAR(transmittance_to_space(0, mu, 1, fine)[i], row.transmittance[i], 2e-4) << row.elevation_deg;
      // The midpoint rule errs by some thousandths of the optical depth with the steps that the table is made with.
      EXPECT_NEAR(transmittance_to_space(0, mu, 1, tabulated)[i], row.transmittance[i], 2e-3) << row.elevation_deg;
    }
}

// At the horizon the path is 1100 km long and 32 bits of altitude matter; 2 % of the red is what the eye cannot tell.
TEST(TransmittanceToSpace, IsRedAtTheHorizon) {
  const vec3 horizon = transmittance_to_space(0, 0, 1, fine);
  EXPECT_NEAR(horizon.x, 0.106429, 0.002);
  EXPECT_NEAR(horizon.y, 0.009580, 0.0005);
  EXPECT_NEAR(horizon.z, 0.000052, 0.00001);
}

TEST(TransmittanceToSpace, GrowsWithElevationAndAltitude) {
  for (const float altitude : {0.0F, 1000.0F, 8000.0F}) {
    vec3 before(0);
    for (int degrees = 0; degrees <= 90; degrees += 2) {
      const vec3 here = transmittance_to_space(altitude, sine(degrees), 1, tabulated);
      for (int i = 0; i < 3; ++i) {
        EXPECT_GT(here[i], before[i]) << altitude << ' ' << degrees;
        EXPECT_LT(transmittance_to_space(altitude, sine(degrees), 2, tabulated)[i], here[i]);
        EXPECT_GT(transmittance_to_space(altitude + 3000, sine(degrees), 1, tabulated)[i], here[i]);
      }
      before = here;
    }
  }
}

TEST(TransmittanceToSpace, IsNothingThroughThePlanet) {
  for (const double degrees : {-90.0, -30.0, -5.0, -2.0})
    EXPECT_EQ(transmittance_to_space(1000, sine(degrees), 1, tabulated), vec3(0)) << degrees;
  EXPECT_GT(transmittance_to_space(1000, sine(-0.9L), 1, tabulated).x, 0);  // the horizon lies 1.016 degrees down
}

double mean_density(double a, double b, double scale_m) {
  return integral([&](long double x) { return std::exp(-std::max<long double>(a + (b - a) * x, 0) / scale_m); }, 0, 1,
                  2000);
}

TEST(AirOpticalDepth, MeetsNumericIntegration) {
  for (const auto& [a, b] :
       {std::pair{0.0, 0.0}, {0.0, 10.0}, {100.0, 1500.0}, {9000.0, 200.0}, {2000.0, 2001.0}, {0.0, 60000.0}})
    for (const float haze : {0.0F, 1.0F, 4.0F}) {
      const vec3 depth = glsl::air_optical_depth(a, b, 70000, haze);
      const double rayleigh[] = {5.802e-6L, 13.558e-6L, 33.1e-6L};
      for (int i = 0; i < 3; ++i) {
        const double expected =
            70000 * (rayleigh[i] * mean_density(a, b, 8000) + haze * 4.44e-6L * mean_density(a, b, 1200));
        EXPECT_NEAR(depth[i] / expected, 1, 1e-4) << a << ' ' << b;
      }
    }
}

TEST(AirOpticalDepth, IsTheSameThereAndBackAndAdds) {
  const vec3 whole = glsl::air_optical_depth(500, 4500, 40000, 1), back = glsl::air_optical_depth(4500, 500, 40000, 1);
  const vec3 halves = glsl::air_optical_depth(500, 2500, 20000, 1) + glsl::air_optical_depth(2500, 4500, 20000, 1);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(back[i] / whole[i], 1, 1e-5);
    EXPECT_NEAR(halves[i] / whole[i], 1, 1e-5);
  }
}

TEST(OzoneDensity, IsATentAbout25Km) {
  EXPECT_EQ(glsl::ozone_density(25000), 1);
  EXPECT_FLOAT_EQ(glsl::ozone_density(17500), 0.5);
  EXPECT_EQ(glsl::ozone_density(10000), 0);
  EXPECT_EQ(glsl::ozone_density(40000), 0);
}

}  // namespace
}  // namespace cloudscape
