#include "bake/in_scatter_beam.h"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

namespace cloudscape::bake {
namespace {

constexpr float dark = 9.2F;  // optical depth

int wrapped(int i, int count) {
  const int rest = i % count;
  return rest < 0 ? rest + count : rest;
}

class Field {
 public:
  explicit Field(const InScatterGrid& grid) : grid_(grid) {}
  // Extinction at a place in units of points, linear between them.
  float at(const glm::vec3& p) const {
    const int x = floored(p.x), y = floored(p.y), z = floored(p.z);
    const float fx = p.x - static_cast<float>(x), fy = p.y - static_cast<float>(y), fz = p.z - static_cast<float>(z);
    const auto row = [&](int j, int k) { return mix(value(x, j, k), value(x + 1, j, k), fx); };
    const auto slice = [&](int k) { return mix(row(y, k), row(y + 1, k), fy); };
    return mix(slice(z), slice(z + 1), fz);
  }

 private:
  static int floored(float v) { return static_cast<int>(std::floor(v)); }
  static float mix(float a, float b, float share) { return a + (b - a) * share; }
  float value(int x, int y, int z) const {
    const glm::ivec3& n = grid_.size;
    if (z < 0 || z >= n.z) return 0;
    if (grid_.periodic)
      x = wrapped(x, n.x), y = wrapped(y, n.y);
    else if (x < 0 || y < 0 || x >= n.x || y >= n.y)
      return 0;
    return grid_.extinction_per_m[static_cast<std::size_t>((z * n.y + y) * n.x + x)];
  }
  const InScatterGrid& grid_;
};

// Steps of a walk to the edge: in points, of one step; and how many there are.
struct Walk {
  glm::vec3 step;
  float step_m;
};

Walk walk_of(const InScatterGrid& grid, const glm::dvec3& direction) {
  const double step_m = 0.7 * std::min({grid.spacing_m.x, grid.spacing_m.y, grid.spacing_m.z});
  return {glm::vec3(direction / grid.spacing_m * step_m), static_cast<float>(step_m)};
}

bool inside(const glm::vec3& p, const InScatterGrid& grid) {
  const auto within = [](float v, int count) { return v > -1 && v < static_cast<float>(count); };
  return within(p.z, grid.size.z) && (grid.periodic || (within(p.x, grid.size.x) && within(p.y, grid.size.y)));
}

}  // namespace

std::vector<float> beam_transmittance(const InScatterGrid& grid, const glm::dvec3& sun_direction) {
  constexpr int most_steps = 4000;  // of a level beam, which a periodic grid never lets out
  const Field field(grid);
  const Walk walk = walk_of(grid, sun_direction);
  std::vector<float> shares;
  shares.reserve(grid.extinction_per_m.size());
  for (int z = 0; z < grid.size.z; ++z)
    for (int y = 0; y < grid.size.y; ++y)
      for (int x = 0; x < grid.size.x; ++x) {
        glm::vec3 p = glm::vec3(x, y, z) + 0.5F * walk.step;
        float depth = 0;
        for (int i = 0; i < most_steps && depth < dark && inside(p, grid); ++i, p += walk.step)
          depth += field.at(p) * walk.step_m;
        shares.push_back(std::exp(-depth));
      }
  return shares;
}

}  // namespace cloudscape::bake
