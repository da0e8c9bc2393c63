// The sun's own beam in a grid of extinction.
#pragma once
#include "bake/in_scatter.h"

namespace cloudscape::bake {

// Share of the beam that arrives at each point: along a straight way to the edge of the grid, which is walked until
// less than a ten-thousandth is left.
std::vector<float> beam_transmittance(const InScatterGrid& grid, const glm::dvec3& sun_direction);

}  // namespace cloudscape::bake
