#include "bake/ordinates.h"

#include <algorithm>
#include <cmath>

namespace cloudscape::bake {

std::vector<Ordinate> ordinates() {
  constexpr float m1 = 0.2666355F, m2 = 0.6815076F, m3 = 0.9261808F;
  constexpr float w1 = 0.1761263F / 8, w2 = 0.1572071F / 8;
  const Ordinate octant[] = {{{m1, m1, m3}, w1}, {{m1, m3, m1}, w1}, {{m3, m1, m1}, w1},
                             {{m1, m2, m2}, w2}, {{m2, m1, m2}, w2}, {{m2, m2, m1}, w2}};
  std::vector<Ordinate> all;
  for (int signs = 0; signs < 8; ++signs) {
    const glm::vec3 sign(signs & 1 ? -1 : 1, signs & 2 ? -1 : 1, signs & 4 ? -1 : 1);
    for (const Ordinate& each : octant) all.push_back({sign * each.direction, each.weight});
  }
  return all;
}

Stencil stencil_of(const glm::vec3& direction, const glm::dvec3& spacing_m) {
  const auto crossing_m = [&](int axis) { return spacing_m[axis] / std::max(1e-6, double(std::abs(direction[axis]))); };
  Stencil stencil;
  for (int axis = 1; axis < 3; ++axis)
    if (crossing_m(axis) < crossing_m(stencil.axis)) stencil.axis = axis;
  const double length_m = crossing_m(stencil.axis);
  for (int axis = 0; axis < 3; ++axis) stencil.towards[axis] = direction[axis] < 0 ? -1 : 1;
  stencil.others = {stencil.axis == 0 ? 1 : 0, stencil.axis == 2 ? 1 : 2};
  for (std::size_t other = 0; other < 2; ++other) {
    const int axis = stencil.others[other];
    stencil.shares[other] = static_cast<float>(std::abs(direction[axis]) * length_m / spacing_m[axis]);
  }
  stencil.length_m = static_cast<float>(length_m);
  return stencil;
}

}  // namespace cloudscape::bake
