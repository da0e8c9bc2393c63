#include "bake/phase_sampling.h"

#include <cmath>
#include <numbers>
#include <numeric>

namespace cloudscape::bake {
namespace {

constexpr double cells = phase_table_cells;

// sin^2 of half the angle at a place in the table, and how fast it grows with the place (shaders/lib/phase.glsl).
double haversine(double coordinate) {
  const double near = std::pow(coordinate, 4), far = std::pow(1 - coordinate, 4);
  return near / (near + far);
}
double haversine_growth(double coordinate) {
  const double near = std::pow(coordinate, 4), far = std::pow(1 - coordinate, 4);
  return 4 * std::pow(coordinate * (1 - coordinate), 3) / std::pow(near + far, 2);
}

// The solid angle of a cell is 4 pi times the difference of the haversines.
double solid_angle_sr(std::size_t cell) {
  const auto at = static_cast<double>(cell);
  return 4 * std::numbers::pi * (haversine((at + 1) / cells) - haversine(at / cells));
}

gpu::Texture uploaded(int width, int height, const std::vector<float>& texels, const char* label) {
  gpu::Texture texture(gpu::Format::rgba32f, width, height, label);
  texture.upload({reinterpret_cast<const std::uint8_t*>(texels.data()), texels.size() * sizeof(float)});
  return texture;
}

}  // namespace

std::vector<AliasCell> alias_cells(const std::vector<double>& weights) {
  const double mean = std::accumulate(weights.begin(), weights.end(), 0.0) / static_cast<double>(weights.size());
  std::vector<AliasCell> table(weights.size());
  std::vector<std::size_t> poor, rich;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    table[i] = {weights[i] / mean, i};
    (table[i].keep < 1 ? poor : rich).push_back(i);
  }
  // Each poor cell is filled up by a rich one, which so becomes poorer; what rounding leaves over is full.
  while (!poor.empty() && !rich.empty()) {
    const std::size_t low = poor.back(), high = rich.back();
    poor.pop_back();
    table[low].alias = high;
    table[high].keep -= 1 - table[low].keep;
    if (table[high].keep >= 1) continue;
    rich.pop_back();
    poor.push_back(high);
  }
  for (const auto* left : {&poor, &rich})
    for (const std::size_t i : *left) table[i].keep = 1;
  return table;
}

std::vector<double> cell_energies(const PhaseTable& table, std::size_t colour) {
  // Gauss-Legendre, four nodes: exact to the digits of a double at these cells.
  constexpr double nodes[] = {0.8611363115940526, 0.3399810435848563},
                   node_weights[] = {0.3478548451374538, 0.6521451548625461};
  const std::vector<double>& texels = table.phase_per_sr[colour];
  std::vector<double> energies(phase_table_cells);
  for (std::size_t cell = 0; cell < phase_table_cells; ++cell) {
    double sum = 0;
    for (std::size_t i = 0; i < 2; ++i)
      for (const double side : {-1.0, 1.0}) {
        const double share = 0.5 + 0.5 * side * nodes[i];
        const double phase = std::lerp(texels[cell], texels[cell + 1], share);
        sum += node_weights[i] * phase * haversine_growth((static_cast<double>(cell) + share) / cells);
      }
    energies[cell] = 4 * std::numbers::pi * sum / (2 * cells);
  }
  return energies;
}

PhaseSampling phase_sampling(const PhaseTable& table) {
  constexpr int width = static_cast<int>(phase_table_cells);
  std::vector<float> texels(4 * phase_table_texels), aliases(4 * 4 * phase_table_cells);
  for (std::size_t colour = 0; colour < 3; ++colour) {
    const std::vector<double> energies = cell_energies(table, colour);
    const std::vector<AliasCell> drawn = alias_cells(energies);
    const double total = std::accumulate(energies.begin(), energies.end(), 0.0);
    for (std::size_t i = 0; i < phase_table_texels; ++i)
      texels[4 * i + colour] = static_cast<float>(table.phase_per_sr[colour][i] / total);
    for (std::size_t cell = 0; cell < phase_table_cells; ++cell) {
      float* row = &aliases[4 * (colour * phase_table_cells + cell)];
      row[0] = static_cast<float>(drawn[cell].keep);
      row[1] = static_cast<float>(drawn[cell].alias);
      aliases[4 * (3 * phase_table_cells + cell) + colour] =
          static_cast<float>(energies[cell] / total / solid_angle_sr(cell));
    }
  }
  return {uploaded(width + 1, 1, texels, "phase texels"), uploaded(width, 4, aliases, "phase aliases")};
}

}  // namespace cloudscape::bake
