// Phase functions: energy, mean cosine, published values.
#include <gtest/gtest.h>

#include "unit/shaders/glsl.h"
#include "unit/shaders/samples.h"

namespace cloudscape {
namespace {

constexpr long double two_pi = 6.283185307179586476925L;
enum Kind { henyey_greenstein, two_lobe, rayleigh, isotropic };  // as core's PhaseKind

template <class Phase>
double energy(Phase phase) {
  return two_pi * integral([&](long double mu) { return phase(static_cast<float>(mu)); }, -1, 1, 200000);
}
template <class Phase>
double mean_cosine(Phase phase) {
  return two_pi * integral([&](long double mu) { return mu * phase(static_cast<float>(mu)); }, -1, 1, 200000);
}

// cos_theta = 1 is forward scattering: the greater value there has g > 0.
TEST(HenyeyGreenstein, MeetsItsValuesForwardSidewaysAndBack) {
  EXPECT_NEAR(glsl::phase_henyey_greenstein(1, 0.85), 6.54304, 2e-4);
  EXPECT_NEAR(glsl::phase_henyey_greenstein(0, 0.85), 0.00976819, 1e-7);
  EXPECT_NEAR(glsl::phase_henyey_greenstein(-1, 0.85), 0.00348769, 1e-7);
  EXPECT_NEAR(glsl::phase_henyey_greenstein(1, -0.3), 0.0329611, 1e-6);
  EXPECT_NEAR(glsl::phase_henyey_greenstein(0, -0.3), 0.0636344, 1e-6);
  EXPECT_NEAR(glsl::phase_henyey_greenstein(-1, -0.3), 0.211124, 1e-6);
}

TEST(HenyeyGreenstein, KeepsEnergyAndItsMeanCosineIsG) {
  for (const float g : {-0.9F, -0.3F, 0.0F, 0.5F, 0.8F, 0.85F, 0.95F}) {
    const auto phase = [g](float mu) { return glsl::phase_henyey_greenstein(mu, g); };
    EXPECT_NEAR(energy(phase), 1, 1e-4) << g;
    EXPECT_NEAR(mean_cosine(phase), g, 1e-4) << g;
  }
}

// At the document's limit the 32 bits of 1 + g^2 - 2 g cos_theta begin to show.
TEST(HenyeyGreenstein, KeepsEnergyAtTheLimitOfG) {
  for (const float g : {-0.99F, 0.99F})
    EXPECT_NEAR(energy([g](float mu) { return glsl::phase_henyey_greenstein(mu, g); }), 1, 1e-3);
}

TEST(Rayleigh, KeepsEnergyAndIsTwiceAsStrongAlongTheBeam) {
  EXPECT_NEAR(energy(glsl::phase_rayleigh), 1, 1e-5);
  EXPECT_NEAR(mean_cosine(glsl::phase_rayleigh), 0, 1e-6);
  EXPECT_FLOAT_EQ(glsl::phase_rayleigh(1), 2 * glsl::phase_rayleigh(0));
  EXPECT_FLOAT_EQ(glsl::phase_rayleigh(-1), glsl::phase_rayleigh(1));
}

// Mean cosine: Cornette and Shanks 1992, g 3 (4 + g^2) / (5 (2 + g^2)).
TEST(CornetteShanks, KeepsEnergyAndItsMeanCosine) {
  for (const float g : {-0.5F, 0.0F, 0.5F, 0.8F, 0.9F}) {
    const auto phase = [g](float mu) { return glsl::phase_cornette_shanks(mu, g); };
    EXPECT_NEAR(energy(phase), 1, 1e-4) << g;
    EXPECT_NEAR(mean_cosine(phase), g * 3 * (4 + g * g) / (5 * (2 + g * g)), 1e-4) << g;
  }
  EXPECT_FLOAT_EQ(glsl::phase_cornette_shanks(0.3, 0), glsl::phase_rayleigh(0.3));
}

TEST(PhaseOfKind, KeepsEnergyForEveryKindAndBroadening) {
  for (const int kind : {henyey_greenstein, two_lobe, rayleigh, isotropic})
    for (const float broadening : {1.0F, 0.6F, 0.1F, 0.0F})
      EXPECT_NEAR(energy([&](float mu) { return glsl::phase_of_kind(kind, mu, 0.8, -0.3, 0.3, broadening); }), 1, 1e-4);
}

TEST(PhaseOfKind, BroadeningScalesTheMeanCosine) {
  const auto mean_of = [](int kind, float broadening) {
    return mean_cosine([&](float mu) { return glsl::phase_of_kind(kind, mu, 0.8, -0.3, 0.25, broadening); });
  };
  EXPECT_NEAR(mean_of(henyey_greenstein, 1), 0.8, 1e-4);
  EXPECT_NEAR(mean_of(henyey_greenstein, 0.5), 0.4, 1e-4);
  EXPECT_NEAR(mean_of(two_lobe, 1), 0.75 * 0.8 - 0.25 * 0.3, 1e-4);
  EXPECT_NEAR(mean_of(two_lobe, 0.5), 0.5 * (0.75 * 0.8 - 0.25 * 0.3), 1e-4);
}

TEST(PhaseOfKind, BroadenedToNothingIsIsotropic) {
  for (const int kind : {henyey_greenstein, two_lobe, rayleigh, isotropic})
    for (const float mu : {-1.0F, 0.2F, 1.0F})
      EXPECT_NEAR(glsl::phase_of_kind(kind, mu, 0.8, -0.3, 0.25, 0), 0.5L / two_pi, 1e-7);
}

}  // namespace
}  // namespace cloudscape
