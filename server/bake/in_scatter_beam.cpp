#include "bake/in_scatter_beam.h"

#include <algorithm>
#include <cmath>
#include <future>
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
    const Pair across = pair_at(x, grid_.size.x), along = pair_at(y, grid_.size.y);
    const auto row = [&](int j, int k) { return mix(value(across.first, j, k), value(across.second, j, k), fx); };
    const auto slice = [&](int k) {
      return k < 0 || k >= grid_.size.z ? 0 : mix(row(along.first, k), row(along.second, k), fy);
    };
    return mix(slice(z), slice(z + 1), fz);
  }

 private:
  struct Pair {
    int first, second;
  };
  static int floored(float v) { return static_cast<int>(std::floor(v)); }
  static float mix(float a, float b, float share) { return a + (b - a) * share; }
  // A point and the next one, around the edges where the grid repeats.
  Pair pair_at(int i, int count) const {
    if (!grid_.periodic) return {i, i + 1};
    const int first = wrapped(i, count);
    return {first, first + 1 == count ? 0 : first + 1};
  }
  float value(int x, int y, int z) const {
    const glm::ivec3& n = grid_.size;
    if (x < 0 || y < 0 || x >= n.x || y >= n.y) return 0;
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

// On two threads, by halves of the layers.
std::vector<float> beam_transmittance(const InScatterGrid& grid, const glm::dvec3& sun_direction) {
  constexpr int most_steps = 4000;  // of a level beam, which a periodic grid never lets out
  const Field field(grid);
  const Walk walk = walk_of(grid, sun_direction);
  std::vector<float> shares(grid.extinction_per_m.size());
  const auto share_at = [&](const glm::vec3& from) {
    glm::vec3 p = from + 0.5F * walk.step;
    float depth = 0;
    for (int i = 0; i < most_steps && depth < dark && inside(p, grid); ++i, p += walk.step)
      depth += field.at(p) * walk.step_m;
    return std::exp(-depth);
  };
  const auto fill = [&](int z_begin, int z_end) {
    std::size_t point = static_cast<std::size_t>(z_begin * grid.size.y * grid.size.x);
    for (int z = z_begin; z < z_end; ++z)
      for (int y = 0; y < grid.size.y; ++y)
        for (int x = 0; x < grid.size.x; ++x) shares[point++] = share_at(glm::vec3(x, y, z));
  };
  // tuned: the lower layers see more cloud above them.
  const int half = grid.size.z * 2 / 5;
  const std::future<void> lower = std::async(std::launch::async, fill, 0, half);
  fill(half, grid.size.z);
  lower.wait();
  return shares;
}

}  // namespace cloudscape::bake
