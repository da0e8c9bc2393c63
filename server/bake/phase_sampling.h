// A phase table as a path tracer draws directions from it.
#pragma once
#include <vector>

#include "bake/phase_table.h"
#include "gpu/texture.h"

namespace cloudscape::bake {

// Walker's alias method (1977): a cell is drawn evenly, and taken with its probability `keep`, or else `alias` is.
struct AliasCell {
  double keep = 1;
  std::size_t alias = 0;
};
std::vector<AliasCell> alias_cells(const std::vector<double>& weights);  // weights >= 0, not all 0

// Share of the energy that is scattered into each cell of the table, of one colour (0..2), by quadrature of what the
// shader interpolates; their sum is 1 but for what the table itself is off.
std::vector<double> cell_energies(const PhaseTable& table, std::size_t colour);

// `texels`: as PhaseTexture, scaled so that all directions together are 1. `aliases`: phase_table_cells wide, 4 high;
// rows 0 to 2: keep and alias of each colour; row 3: mean over each cell, red, green, blue, 1/sr.
struct PhaseSampling {
  gpu::Texture texels, aliases;
};
PhaseSampling phase_sampling(const PhaseTable& table);

}  // namespace cloudscape::bake
