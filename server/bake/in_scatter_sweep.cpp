#include "bake/in_scatter_sweep.h"

#include <cmath>

namespace cloudscape::bake {
namespace {

// What is left of what comes in, and what the sources at both ends of a step add, for sources that change evenly.
struct Step {
  float kept, far, near;
};

Step step_of(float optical_depth) {
  if (optical_depth < 0.01F) {
    const float half = 0.5F * optical_depth;
    return {1 - optical_depth + half * optical_depth, half * (1 - 2.0F / 3 * optical_depth),
            half * (1 - optical_depth / 3)};
  }
  const float kept = std::exp(-optical_depth), mean = (1 - kept) / optical_depth;
  return {kept, mean - kept, 1 - mean};
}

Colours sum_of(const std::vector<Colours>& values, std::size_t begin, int count) {
  Colours sum{};
  for (int i = 0; i < count; ++i) sum += values[begin + static_cast<std::size_t>(i)];
  return sum;
}

}  // namespace

// A direction and how the grid is stored along it.
struct Sweeper::Path {
  Ordinate ordinate;
  Stencil stencil;
  Colours around{};
  std::span<const Moments> source = {};
  std::array<int, 2> counts{};           // points of a plane along its axes
  std::size_t stride = 1;                // between planes
  std::array<std::size_t, 2> strides{};  // along the plane's axes
  bool periodic = false;                 // along the sweep
  std::size_t points() const { return static_cast<std::size_t>(counts[0]) * static_cast<std::size_t>(counts[1]); }
};

Sweeper::Sweeper(const InScatterGrid& grid) : grid_(grid), ordinates_(ordinates()) {}

void Sweeper::load(Plane& plane, const Path& path, int layer) const {
  const glm::vec3& d = path.ordinate.direction;
  const Colours x = all_of(d.x), y = all_of(d.y), z = all_of(d.z);
  std::size_t point = 0;
  for (int c = 0; c < path.counts[1]; ++c) {
    std::size_t index = static_cast<std::size_t>(layer) * path.stride + static_cast<std::size_t>(c) * path.strides[1];
    for (int b = 0; b < path.counts[0]; ++b, ++point, index += path.strides[0]) {
      const Moments& moments = path.source[index];
      plane.source[point] = moments.even + moments.east * x + moments.north * y + moments.up * z;
      plane.extinction[point] = grid_.extinction_per_m[index];
    }
  }
}

// Radiance in the points of a layer, from that in the layer before.
void Sweeper::cross(const Path& path, int layer, Arrived& arrived) {
  const auto [share_b, share_c] = path.stencil.shares;
  const std::array<Colours, 4> weights{all_of((1 - share_b) * (1 - share_c)), all_of(share_b * (1 - share_c)),
                                       all_of((1 - share_b) * share_c), all_of(share_b * share_c)};
  const float half_m = 0.5F * path.stencil.length_m;
  const glm::vec3 d = path.ordinate.direction;
  // The mean over the layer of radiance times cosine, over the sphere.
  const Colours flux =
      all_of(12.566371F * path.ordinate.weight * d.z / static_cast<float>(grid_.size.x * grid_.size.y));
  const Colours weight = all_of(path.ordinate.weight), x = all_of(d.x), y = all_of(d.y), z = all_of(d.z);
  const int along_b = path.stencil.towards[path.stencil.others[0]],
            along_c = path.stencil.towards[path.stencil.others[1]];
  const int count_b = path.counts[0], count_c = path.counts[1];
  const bool wraps_b = grid_.periodic, wraps_c = grid_.periodic && path.stencil.others[1] != 2;
  for (int c = 0; c < count_c; ++c) {
    int next_c = c + along_c;
    const bool out_c = next_c < 0 || next_c >= count_c;
    if (out_c) next_c = (next_c + count_c) % count_c;
    const std::size_t row = static_cast<std::size_t>(c * count_b),
                      next_row = static_cast<std::size_t>(next_c * count_b);
    std::size_t index = static_cast<std::size_t>(layer) * path.stride + static_cast<std::size_t>(c) * path.strides[1];
    for (int b = 0; b < count_b; ++b, index += path.strides[0]) {
      int next_b = b + along_b;
      const bool out_b = next_b < 0 || next_b >= count_b;
      if (out_b) next_b = (next_b + count_b) % count_b;
      const std::size_t at = row + static_cast<std::size_t>(b);
      Colours radiance = path.around;
      if ((!out_b || wraps_b) && (!out_c || wraps_c)) {
        const std::array<std::size_t, 4> from{at, row + static_cast<std::size_t>(next_b),
                                              next_row + static_cast<std::size_t>(b),
                                              next_row + static_cast<std::size_t>(next_b)};
        Colours came{}, source{}, extinction{};
        for (std::size_t i = 0; i < 4; ++i) {
          came += weights[i] * before_.radiance[from[i]];
          source += weights[i] * before_.source[from[i]];
          extinction += weights[i] * all_of(before_.extinction[from[i]]);
        }
        const Step step = step_of(half_m * (extinction[0] + now_.extinction[at]));
        radiance = came * all_of(step.kept) + source * all_of(step.far) + now_.source[at] * all_of(step.near);
      }
      now_.radiance[at] = radiance;
      const Colours share = weight * radiance;
      Moments& sum = arrived.at[index];
      sum.even += share, sum.east += share * x, sum.north += share * y, sum.up += share * z;
    }
    const int height = path.stencil.axis == 2 ? layer : c;
    if (height == 0 && d.z > 0) arrived.down += flux * sum_of(now_.radiance, row, count_b);
    if (height == grid_.size.z - 1 && d.z < 0) arrived.up -= flux * sum_of(now_.radiance, row, count_b);
  }
}

void Sweeper::follow(const Path& path, std::span<Colours> crossing, Arrived& arrived) {
  for (Plane* plane : {&now_, &before_})
    plane->radiance.resize(path.points()), plane->source.resize(path.points()), plane->extinction.resize(path.points());
  const int layers = grid_.size[path.stencil.axis];
  const bool falls = path.stencil.towards[path.stencil.axis] > 0;  // light comes from the far end
  if (path.periodic) {
    load(before_, path, falls ? 0 : layers - 1);
    std::copy(crossing.begin(), crossing.end(), before_.radiance.begin());
  } else {
    std::fill(before_.radiance.begin(), before_.radiance.end(), path.around);
    std::fill(before_.source.begin(), before_.source.end(), Colours{});
    std::fill(before_.extinction.begin(), before_.extinction.end(), 0.0F);
  }
  for (int i = 0; i < layers; ++i) {
    const int layer = falls ? layers - 1 - i : i;
    load(now_, path, layer);
    cross(path, layer, arrived);
    std::swap(now_, before_);
  }
  if (path.periodic) std::copy(before_.radiance.begin(), before_.radiance.end(), crossing.begin());
}

Sweeper::Path Sweeper::path_of(const Ordinate& ordinate) const {
  const std::array<std::size_t, 3> strides{
      1, static_cast<std::size_t>(grid_.size.x),
      static_cast<std::size_t>(grid_.size.x) * static_cast<std::size_t>(grid_.size.y)};
  Path path{ordinate, stencil_of(ordinate.direction, grid_.spacing_m)};
  const auto [b, c] = path.stencil.others;
  path.counts = {grid_.size[b], grid_.size[c]};
  path.stride = strides[static_cast<std::size_t>(path.stencil.axis)];
  path.strides = {strides[static_cast<std::size_t>(b)], strides[static_cast<std::size_t>(c)]};
  path.periodic = grid_.periodic && path.stencil.axis != 2;
  return path;
}

std::size_t Sweeper::crossing_count() const {
  std::size_t count = 0;
  for (const Ordinate& ordinate : ordinates_)
    if (const Path path = path_of(ordinate); path.periodic) count += path.points();
  return count;
}

Sweeper::Arrived Sweeper::sweep(std::span<const Moments> source, const std::vector<Colours>& around,
                                std::span<Colours> crossing) {
  Arrived arrived;
  arrived.at.assign(source.size(), Moments{});
  for (std::size_t i = 0; i < ordinates_.size(); ++i) {
    Path path = path_of(ordinates_[i]);
    path.around = around[i], path.source = source;
    const std::size_t crosses = path.periodic ? path.points() : 0;
    follow(path, crossing.first(crosses), arrived);
    crossing = crossing.subspan(crosses);
  }
  return arrived;
}

}  // namespace cloudscape::bake
