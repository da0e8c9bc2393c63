// The clear atmosphere against closed forms, and against values of an independent integration.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/shaders/glsl.h"
#include "unit/shaders/samples.h"

namespace cloudscape {
namespace {

using glsl::transmittance_to_space, glsl::vec3, glsl::Atmosphere;

constexpr int fine = 500;
constexpr int tabulated = 64;  // as the transmittance table is made
double sine(double degrees) { return std::sin(degrees * 3.141592653589793238L / 180); }
Atmosphere with_haze(float haze) { return {1, haze, 1, 1200, 0.8F}; }
const Atmosphere earth = with_haze(1);

// Up, the integral of each density is known: H (1 - exp(-100 km / H)), and 15 km of ozone.
TEST(TransmittanceToSpace, MeetsTheClosedFormStraightUp) {
  const double rayleigh_m = 8000 * (1 - std::exp(-12.5)), aerosol_m = 1200;
  const vec3 clear = transmittance_to_space(0, 1, with_haze(0), fine);
  const vec3 hazy = transmittance_to_space(0, 1, with_haze(3), fine);
  const double rayleigh[] = {7.18e-6L, 13.73e-6L, 32.22e-6L}, ozone[] = {2.487e-6L, 1.795e-6L, 0};
  for (int i = 0; i < 3; ++i) {
    const double depth = rayleigh[i] * rayleigh_m + ozone[i] * 15000;
    EXPECT_NEAR(clear[i], std::exp(-depth), 1e-4);
    EXPECT_NEAR(hazy[i], std::exp(-depth - 3 * 4.44e-6L * aerosol_m), 1e-4);
  }
}

TEST(TransmittanceToSpace, HasEachConstituentByItsFactor) {
  const auto depth = [](const Atmosphere& air) { return -std::log(double(transmittance_to_space(0, 1, air, fine).y)); };
  const Atmosphere none{0, 0, 0, 1200, 0.8F};
  EXPECT_EQ(depth(none), 0);
  Atmosphere air = none;
  air.rayleigh = 2;
  EXPECT_NEAR(depth(air), 2 * 13.73e-6L * 8000, 1e-4);
  air = none, air.ozone = 3;
  EXPECT_NEAR(depth(air), 3 * 1.795e-6L * 15000, 1e-4);
  air = none, air.haze = 2, air.aerosol_scale_m = 3000;
  EXPECT_NEAR(depth(air), 2 * 4.44e-6L * 3000, 1e-4);
}

struct Row {
  double elevation_deg;
  std::array<double, 3> transmittance;
};
// From sea level, of an integration in double precision that is not ours.
const Row table[] = {{90, {0.904772L, 0.867541L, 0.768675L}},
                     {30, {0.819670L, 0.753714L, 0.591998L}},
                     {10, {0.581859L, 0.458924L, 0.231978L}},
                     {5, {0.388706L, 0.248600L, 0.069047L}},
                     {0, {0.052362L, 0.009262L, 0.000068L}}};

TEST(TransmittanceToSpace, MeetsAnIndependentIntegration) {
  for (const Row& row : table)
    for (std::size_t i = 0; i < 3; ++i) {
      const float mu = sine(row.elevation_deg);
      const double expected = row.transmittance[i];
      EXPECT_NEAR(transmittance_to_space(0, mu, earth, fine)[i], expected, 0.003 * expected + 1e-6)
          << row.elevation_deg;
      // The midpoint rule errs by some thousandths of the optical depth with the steps that the table is made with.
      EXPECT_NEAR(transmittance_to_space(0, mu, earth, tabulated)[i], expected, 0.02 * expected) << row.elevation_deg;
    }
}

TEST(TransmittanceToSpace, GrowsWithElevationAndAltitude) {
  for (const float altitude : {0.0F, 1000.0F, 8000.0F}) {
    vec3 before(0);
    for (int degrees = 0; degrees <= 90; degrees += 2) {
      const vec3 here = transmittance_to_space(altitude, sine(degrees), earth, tabulated);
      for (int i = 0; i < 3; ++i) {
        EXPECT_GT(here[i], before[i]) << altitude << ' ' << degrees;
        EXPECT_LT(transmittance_to_space(altitude, sine(degrees), with_haze(2), tabulated)[i], here[i]);
        EXPECT_GT(transmittance_to_space(altitude + 3000, sine(degrees), earth, tabulated)[i], here[i]);
      }
      before = here;
    }
  }
}

TEST(DiscAboveHorizon, IsAHalfAtTheHorizon) {
  const float radius = 0.00468F;
  for (const double altitude : {0.0, 1000.0, 12000.0}) {
    const double dip = std::acos(6360000 / (6360000 + altitude));
    EXPECT_NEAR(glsl::disc_above_horizon(altitude, std::sin(-dip), radius), 0.5, 0.05) << altitude;
    EXPECT_EQ(glsl::disc_above_horizon(altitude, std::sin(-dip - 1.1 * radius), radius), 0);
    EXPECT_EQ(glsl::disc_above_horizon(altitude, std::sin(-dip + 1.1 * radius), radius), 1);
  }
}

TEST(PathShare, GoesFromNoughtToOne) {
  for (const float evenness : {0.0F, 0.4F, 1.0F}) {
    EXPECT_EQ(glsl::path_share(0, evenness), 0);
    EXPECT_EQ(glsl::path_share(1, evenness), 1);
  }
  EXPECT_EQ(glsl::path_evenness(100, 0.3F, 1e5F), 0);        // upwards
  EXPECT_EQ(glsl::path_evenness(12000, -0.06F, 7.6e5F), 1);  // through the lowest point in the middle
}

TEST(OzoneDensity, IsATentAbout25Km) {
  EXPECT_EQ(glsl::ozone_density(25000), 1);
  EXPECT_FLOAT_EQ(glsl::ozone_density(17500), 0.5);
  EXPECT_EQ(glsl::ozone_density(10000), 0);
  EXPECT_EQ(glsl::ozone_density(40000), 0);
}

// Neckel and Labs 1994 have 0.70 at half the cosine and 550 nm; and a disc has its mean.
TEST(LimbDarkening, IsThatOfTheSun) {
  const vec3 middle = glsl::limb_darkening(0);
  const vec3 half = glsl::limb_darkening(std::sqrt(0.75));
  EXPECT_NEAR(half.y / middle.y, 0.70, 0.01);
  EXPECT_LT(half.z / middle.z, half.x / middle.x);  // blue falls off faster: the limb is reddish
  for (int i = 0; i < 3; ++i) {
    const double mean = integral([&](long double r) { return 2 * r * glsl::limb_darkening(r)[i]; }, 0, 1, 20000);
    EXPECT_NEAR(mean, 1, 2e-3);
  }
}

}  // namespace
}  // namespace cloudscape
