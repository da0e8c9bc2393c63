#include "bake/in_scatter_coarse.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace cloudscape::bake {
namespace {

std::size_t index_of(const glm::ivec3& at, const glm::ivec3& size) {
  return (static_cast<std::size_t>(at.z) * static_cast<std::size_t>(size.y) + static_cast<std::size_t>(at.y)) *
             static_cast<std::size_t>(size.x) +
         static_cast<std::size_t>(at.x);
}

// The two coarse points about a fine one along an axis, and the share of the second.
struct Between {
  int first, second;
  float share;
};
Between between(int fine, int coarse_count, bool periodic) {
  const double at = (fine - 0.5) / 2;
  const int below = static_cast<int>(std::floor(at));
  const auto inside = [&](int i) {
    return periodic ? (i + coarse_count) % coarse_count : std::clamp(i, 0, coarse_count - 1);
  };
  return {inside(below), inside(below + 1), static_cast<float>(at - below)};
}

void add(Moments& sum, const Moments& part, float share) {
  const Colours weight{share, share, share, share};
  sum.even += weight * part.even, sum.east += weight * part.east;
  sum.north += weight * part.north, sum.up += weight * part.up;
}

}  // namespace

InScatterProblem coarse_problem(const InScatterProblem& fine) {
  InScatterProblem coarse = fine;
  InScatterGrid& grid = coarse.grid;
  const glm::ivec3 size = fine.grid.size;
  grid.size = (size + 1) / 2;
  grid.spacing_m *= 2;
  grid.extinction_per_m.assign(index_of({0, 0, grid.size.z}, grid.size), 0.0F);
  for (int z = 0; z < grid.size.z * 2; ++z)
    for (int y = 0; y < grid.size.y * 2; ++y)
      for (int x = 0; x < grid.size.x * 2; ++x) {
        const glm::ivec3 at = glm::min(glm::ivec3(x, y, z), size - 1);
        grid.extinction_per_m[index_of(glm::ivec3(x, y, z) / 2, grid.size)] +=
            0.125F * fine.grid.extinction_per_m[index_of(at, size)];
      }
  std::vector<glm::vec3>& sun = coarse.light.sun_irradiance;
  sun.clear();
  for (std::size_t z = 0; z < static_cast<std::size_t>(size.z); z += 2) sun.push_back(fine.light.sun_irradiance[z]);
  return coarse;
}

std::vector<Moments> refined(const std::vector<Moments>& coarse, const InScatterGrid& coarse_grid,
                             const InScatterGrid& fine) {
  std::vector<Moments> light;
  light.reserve(fine.extinction_per_m.size());
  const glm::ivec3& n = coarse_grid.size;
  for (int z = 0; z < fine.size.z; ++z)
    for (int y = 0; y < fine.size.y; ++y)
      for (int x = 0; x < fine.size.x; ++x) {
        const Between bx = between(x, n.x, fine.periodic), by = between(y, n.y, fine.periodic),
                      bz = between(z, n.z, false);
        Moments sum;
        for (int corner = 0; corner < 8; ++corner) {
          const auto along = [corner](const Between& b, int bit) {
            return corner >> bit & 1 ? std::pair(b.second, b.share) : std::pair(b.first, 1 - b.share);
          };
          const auto [cx, sx] = along(bx, 0);
          const auto [cy, sy] = along(by, 1);
          const auto [cz, sz] = along(bz, 2);
          add(sum, coarse[index_of({cx, cy, cz}, n)], sx * sy * sz);
        }
        light.push_back(sum);
      }
  return light;
}

}  // namespace cloudscape::bake
