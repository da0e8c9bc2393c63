// What a cloud of droplets makes of light: against values from an independent program of 25,000 radii and 2,700 angles,
// and against what holds for any phase function.
#include "bake/mie_phase.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "bake/droplet_sizes.h"

namespace cloudscape::bake {
namespace {

constexpr double degree = std::numbers::pi / 180;
enum Colour { red, green, blue };

const PhaseTable& cloud_of_10_um() {
  static const PhaseTable table = *mie_phase_table({});
  return table;
}

// Integral over the sphere of phase times weight(angle), out to `end_rad`, as the march interpolates the table.
double integral(const PhaseTable& table, Colour colour, const std::function<double(double)>& weight,
                double end_rad = std::numbers::pi) {
  constexpr int steps = 4 * phase_table_cells;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double begin = phase_angle_rad(static_cast<double>(i) / steps);
    const double end = phase_angle_rad(static_cast<double>(i + 1) / steps);
    const double middle = (begin + end) / 2;
    if (middle > end_rad) break;
    const double solid_angle = 4 * std::numbers::pi * std::sin(middle) * std::sin((end - begin) / 2);
    sum += table.at(middle)[colour] * weight(middle) * solid_angle;
  }
  return sum;
}
double energy(const PhaseTable& table, Colour colour, double end_rad = std::numbers::pi) {
  return integral(
      table, colour, [](double) { return 1.0; }, end_rad);
}
double mean_cosine(const PhaseTable& table, Colour colour) {
  return integral(table, colour, [](double angle) { return std::cos(angle); });
}

struct Peak {
  double angle_deg = 0, phase = 0;
};
Peak greatest(const PhaseTable& table, Colour colour, double from_deg, double to_deg) {
  Peak peak;
  for (double angle_deg = from_deg; angle_deg <= to_deg; angle_deg += 0.01)
    if (const double phase = table.at(angle_deg * degree)[colour]; phase > peak.phase) peak = {angle_deg, phase};
  return peak;
}

TEST(MiePhase, OfTenMicrometresMeetsTheKnownValues) {
  const PhaseTable& table = cloud_of_10_um();
  EXPECT_NEAR(table.optics[green].asymmetry_g, 0.8640, 2e-4);
  EXPECT_NEAR(table.optics[green].extinction_efficiency, 2.0899, 5e-4);
  EXPECT_NEAR(table.at(0)[green], 592.2, 0.5);
  EXPECT_NEAR(table.at(90 * degree)[green], 0.00210, 0.00002);
  EXPECT_NEAR(table.at(180 * degree)[green], 0.05303, 0.002);  // the one angle where single radii still count
  EXPECT_NEAR(energy(table, green, 1 * degree), 0.29, 0.005);
  EXPECT_NEAR(energy(table, green, 5 * degree), 0.48, 0.005);
}

TEST(MiePhase, OfTenMicrometresHasAFogBowAndAGlory) {
  const PhaseTable& table = cloud_of_10_um();
  const Peak bow = greatest(table, green, 130, 160), ring = greatest(table, green, 177.8, 179.2);
  EXPECT_NEAR(bow.angle_deg, 141.5, 0.3);
  EXPECT_NEAR(bow.phase, 0.02684, 0.0004);
  EXPECT_NEAR(bow.phase / table.at(120 * degree)[green], 8.2, 0.2);
  EXPECT_NEAR(ring.angle_deg, 178.52, 0.05);
  // Red lies outside: about the point opposite the sun, where it is bent more, and of the bow.
  EXPECT_LT(greatest(table, red, 177.8, 179.2).angle_deg, ring.angle_deg - 0.1);
  EXPECT_GT(greatest(table, blue, 177.8, 179.2).angle_deg, ring.angle_deg + 0.1);
}

TEST(MiePhase, AlmostAllLightIsScattered) {
  for (const DropletOptics& optics : cloud_of_10_um().optics) {
    EXPECT_GT(optics.single_scattering_albedo, 0.99999);
    EXPECT_LT(optics.single_scattering_albedo, 1);
  }
}

// Over the whole range of documents.
TEST(MiePhase, KeepsEnergyAndItsMeanCosineAsATable) {
  const PhaseRecipe recipes[] = {{}, {1, 1, 0.01}, {1, 1, 0.5}, {1, 10, 0.5}, {1, 50, 0.01}, {1, 50, 0.5}};
  for (const PhaseRecipe& recipe : recipes) {
    const PhaseTable table = *mie_phase_table(recipe, {.radii = recipe.effective_radius_um > 10 ? 1000 : 300});
    for (const Colour colour : {red, green, blue}) {
      EXPECT_NEAR(energy(table, colour), 1, 1e-3) << recipe.effective_radius_um << " " << recipe.effective_variance;
      EXPECT_NEAR(mean_cosine(table, colour), table.optics[colour].asymmetry_g, 5e-4)
          << recipe.effective_radius_um << " " << recipe.effective_variance;
    }
  }
}

double rms_difference(const PhaseTable& left, const PhaseTable& right, Colour colour) {
  double sum = 0;
  for (std::size_t i = 0; i < phase_table_texels; ++i)
    sum += std::pow(left.phase_per_sr[colour][i] / right.phase_per_sr[colour][i] - 1, 2);
  return std::sqrt(sum / phase_table_texels);
}

// More radii would not change what is seen.
TEST(MiePhase, TheDefaultNumberOfRadiiIsEnough) {
  const PhaseRecipe recipe{.effective_radius_um = 5};
  const PhaseTable usual = *mie_phase_table(recipe), fine = *mie_phase_table(recipe, {.radii = 15000});
  for (const Colour colour : {red, green, blue}) EXPECT_LT(rms_difference(usual, fine, colour), 0.01);
  EXPECT_GT(rms_difference(*mie_phase_table(recipe, {.radii = 200}), fine, green), 0.02);
}

// Equally spaced radii put spikes of 10 to 60 % into wide distributions, where two rays interfere alike in all of them.
TEST(MiePhase, AWideDistributionHasNoSpikes) {
  const PhaseTable table = *mie_phase_table({.effective_radius_um = 10, .effective_variance = 0.5}, {.radii = 1000});
  for (const Colour colour : {red, green, blue}) {
    const std::vector<double>& phase = table.phase_per_sr[colour];
    for (std::size_t i = 8; i + 8 < phase.size(); ++i) {
      const double angle_deg = phase_angle_rad(static_cast<double>(i) / phase_table_cells) / degree;
      if (angle_deg < 2 || angle_deg > 125) continue;  // peak, bow and glory are curved by nature
      EXPECT_NEAR(phase[i] / std::sqrt(phase[i - 8] * phase[i + 8]), 1, 0.12) << angle_deg;
    }
  }
}

TEST(MiePhase, IsTheSameWithAnyNumberOfThreads) {
  const PhaseRecipe recipe{.effective_radius_um = 3};
  EXPECT_EQ(mie_phase_table(recipe, {.radii = 100, .threads = 1}),
            mie_phase_table(recipe, {.radii = 100, .threads = 3}));
}

TEST(MiePhase, StopsWhenItIsAskedTo) {
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(mie_phase_table({.effective_radius_um = 50}, {}, source.get_token()));
}

TEST(DropletSizes, HaveTheEffectiveRadiusAndVariance) {
  for (const PhaseRecipe& recipe : {PhaseRecipe{}, PhaseRecipe{1, 1, 0.01}, PhaseRecipe{1, 50, 0.5}}) {
    double radius_um = 0, variance_um2 = 0;
    for (const Droplets& size : droplet_sizes(recipe)) radius_um += size.area * size.radius_um;
    for (const Droplets& size : droplet_sizes(recipe))
      variance_um2 += size.area * std::pow(size.radius_um - radius_um, 2);
    EXPECT_NEAR(radius_um / recipe.effective_radius_um, 1, 1e-3);
    EXPECT_NEAR(variance_um2 / std::pow(radius_um, 2) / recipe.effective_variance, 1, 5e-3);
  }
}

TEST(SeenByDisc, BlursThePeakAndTheGloryAndNotTheBow) {
  const PhaseTable& table = cloud_of_10_um();
  const PhaseTable seen = seen_by_disc(table, 0.268 * degree);
  EXPECT_LT(seen.at(0)[green], 0.98 * table.at(0)[green]);
  EXPECT_GT(seen.at(0)[green], 0.9 * table.at(0)[green]);
  EXPECT_NEAR(seen.at(141.5 * degree)[green] / table.at(141.5 * degree)[green], 1, 0.003);
  for (const Colour colour : {red, green, blue}) {
    EXPECT_NEAR(energy(seen, colour), 1, 1e-3);
    EXPECT_NEAR(mean_cosine(seen, colour), table.optics[colour].asymmetry_g, 5e-4);
  }
}

// The mean of a linear function of the cosine over a disc about the axis is known.
TEST(SeenByDisc, IsTheMeanOverTheDisc) {
  PhaseTable table = cloud_of_10_um();
  for (std::size_t i = 0; i < phase_table_texels; ++i)
    table.phase_per_sr[green][i] = 1 - std::cos(phase_angle_rad(static_cast<double>(i) / phase_table_cells));
  const double radius_rad = 10 * degree;
  EXPECT_NEAR(seen_by_disc(table, radius_rad).at(0)[green], (1 - std::cos(radius_rad)) / 2, 1e-4);
  EXPECT_NEAR(seen_by_disc(table, radius_rad).at(std::numbers::pi)[green], 2 - (1 - std::cos(radius_rad)) / 2, 1e-4);
}

}  // namespace
}  // namespace cloudscape::bake
