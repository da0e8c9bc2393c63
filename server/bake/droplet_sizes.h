// The radii that stand for a distribution of droplets.
#pragma once
#include <vector>

#include "bake/phase_table.h"

namespace cloudscape::bake {

struct Droplets {
  double radius_um = 0;
  double area = 0;  // share of the cross-section of all droplets
};

// `count` radii of the gamma distribution n(r) ~ r^((1 - 3v) / v) exp(-r / (a v)) with the effective radius a and the
// effective variance v (Hansen 1971), ascending; 0: as many as the default effort allows.
std::vector<Droplets> droplet_sizes(const PhaseRecipe& recipe, int count = 0);

}  // namespace cloudscape::bake
