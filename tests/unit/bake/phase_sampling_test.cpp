// Drawing from a phase table: shares of the cells, and the alias method.
#include "bake/phase_sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace cloudscape::bake {
namespace {

// Isotropic, Henyey-Greenstein, and Rayleigh in the three colours.
PhaseTable known_table() {
  PhaseTable table;
  const double g = 0.9;
  for (std::size_t texel = 0; texel < phase_table_texels; ++texel) {
    const double mu = std::cos(phase_angle_rad(static_cast<double>(texel) / phase_table_cells));
    table.phase_per_sr[0].push_back(1 / (4 * std::numbers::pi));
    table.phase_per_sr[1].push_back((1 - g * g) / (4 * std::numbers::pi * std::pow(1 + g * g - 2 * g * mu, 1.5)));
    table.phase_per_sr[2].push_back(3 / (16 * std::numbers::pi) * (1 + mu * mu));
  }
  return table;
}

TEST(PhaseSampling, EnergiesOfTheCellsAreThoseOfTheFunction) {
  const PhaseTable table = known_table();
  const double g = 0.9;
  const auto below = [g](double mu) {
    return (1 - g * g) / (2 * g) * (1 / std::sqrt(1 + g * g - 2 * g * mu) - 1 / (1 + g));
  };
  for (std::size_t colour = 0; colour < 3; ++colour) {
    const std::vector<double> energies = cell_energies(table, colour);
    EXPECT_NEAR(std::accumulate(energies.begin(), energies.end(), 0.0), 1, 5e-5) << colour;  // linear between texels
    for (const std::size_t cell : {0U, 10U, 400U, 768U, 1200U, 1535U}) {
      const double low = std::cos(phase_angle_rad((cell + 1.0) / phase_table_cells));
      const double high = std::cos(phase_angle_rad(static_cast<double>(cell) / phase_table_cells));
      const double expected = colour == 0   ? (high - low) / 2
                              : colour == 1 ? below(high) - below(low)
                                            : 0.375 * (high - low + (std::pow(high, 3) - std::pow(low, 3)) / 3);
      EXPECT_NEAR(energies[cell], expected, 1e-4 * expected + 1e-13) << colour << " cell " << cell;
    }
  }
}

TEST(PhaseSampling, AliasesGiveEachCellItsShare) {
  const std::vector<double> weights{5, 0, 1, 3, 0.001, 20, 7};
  const std::vector<AliasCell> cells = alias_cells(weights);
  std::vector<double> shares(weights.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_GE(cells[i].keep, 0);
    EXPECT_LE(cells[i].keep, 1);
    shares[i] += cells[i].keep / static_cast<double>(cells.size());
    shares[cells[i].alias] += (1 - cells[i].keep) / static_cast<double>(cells.size());
  }
  for (std::size_t i = 0; i < weights.size(); ++i) EXPECT_NEAR(shares[i], weights[i] / 36.001, 1e-12) << i;
}

}  // namespace
}  // namespace cloudscape::bake
