// A problem on a grid of half as many points along each axis, and its solution on the fine grid: where the iteration
// begins, so that light need not find its way through thick clouds point by point.
#pragma once
#include "bake/in_scatter.h"

namespace cloudscape::bake {

// Each coarse point stands for two fine ones along each axis; the last alone for an odd one.
InScatterProblem coarse_problem(const InScatterProblem& fine);
// The light of a coarse solution at the points of the fine grid, linear between the coarse ones.
std::vector<Moments> refined(const std::vector<Moments>& coarse, const InScatterGrid& coarse_grid,
                             const InScatterGrid& fine);

}  // namespace cloudscape::bake
