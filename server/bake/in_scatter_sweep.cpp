#include "bake/in_scatter_sweep.h"

#include <cmath>
#include <future>

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

// A direction of a group.
struct Sweeper::Path {
  Ordinate ordinate;
  Stencil stencil;
  Colours around{};
};

// Directions that go through the same layers of the grid in the same order, and how the grid is stored along them.
struct Sweeper::Group {
  std::vector<Path> paths;
  int axis = 2;
  bool falls = true;                     // light comes from the far end
  bool periodic = false;                 // along the sweep
  std::array<int, 2> counts{};           // points of a layer along its axes
  std::size_t stride = 1;                // between layers
  std::array<std::size_t, 2> strides{};  // along the layer's axes
  std::size_t points() const { return static_cast<std::size_t>(counts[0]) * static_cast<std::size_t>(counts[1]); }
  std::size_t crossing_count() const { return periodic ? paths.size() * points() : 0; }
};

namespace {

// The point beside i, around the edge if that is out of the layer.
struct Neighbour {
  int index;
  bool out;
};
Neighbour neighbour_of(int i, int towards, int count) {
  const int next = i + towards;
  if (next < 0) return {next + count, true};
  if (next >= count) return {next - count, true};
  return {next, false};
}

// use(point, index): each point of a layer, and where the grid has it.
template <class Group>
void each_point(const Group& group, int layer, auto&& use) {
  std::size_t point = 0;
  for (int c = 0; c < group.counts[1]; ++c) {
    std::size_t index = static_cast<std::size_t>(layer) * group.stride + static_cast<std::size_t>(c) * group.strides[1];
    for (int b = 0; b < group.counts[0]; ++b, ++point, index += group.strides[0]) use(point, index);
  }
}

}  // namespace

// What sweeps one group after the other, and what arrived by them.
class Sweeper::Hand {
 public:
  explicit Hand(const InScatterGrid& grid) : grid_(grid) {}
  void begin_iteration(std::size_t points) {
    arrived_ = {};
    arrived_.at.assign(points, Moments{});
  }
  void follow(const Group& group, std::span<const Moments> source, std::span<Colours> crossing);
  const Arrived& arrived() const { return arrived_; }

 private:
  // Of one direction in the points of a layer.
  struct Plane {
    std::vector<Colours> radiance, source;
  };
  void begin(const Group& group, std::span<const Moments> source, std::span<const Colours> crossing);
  void load(const Group& group, std::span<const Moments> source, int layer);
  void mix_rows(const Plane& before, std::size_t row, std::size_t next_row, float share);
  void cross(const Group& group, std::size_t number);
  void add(const Group& group, int layer);

  const InScatterGrid& grid_;
  std::vector<Plane> now_, before_;  // by direction of a group
  std::vector<float> extinction_, extinction_before_;
  std::vector<Moments> moments_;  // of the layer: its sources, then what came to it
  // Of the layer before, where paths from a row meet it.
  struct Crossed {
    Colours radiance, source;
    float extinction;
  };
  std::vector<Crossed> mixed_;
  Arrived arrived_;
};

Sweeper::Sweeper(const InScatterGrid& grid)
    : grid_(grid), ordinates_(ordinates()), hands_{std::make_unique<Hand>(grid), std::make_unique<Hand>(grid)} {}
Sweeper::~Sweeper() = default;

std::vector<Sweeper::Group> Sweeper::groups(const std::vector<Colours>& around) const {
  const std::array<std::size_t, 3> strides{
      1, static_cast<std::size_t>(grid_.size.x),
      static_cast<std::size_t>(grid_.size.x) * static_cast<std::size_t>(grid_.size.y)};
  std::vector<Group> groups(6);
  for (std::size_t i = 0; i < ordinates_.size(); ++i) {
    const Stencil stencil = stencil_of(ordinates_[i].direction, grid_.spacing_m);
    const auto [b, c] = stencil.others;
    Group& group = groups[2 * static_cast<std::size_t>(stencil.axis) + (stencil.towards[stencil.axis] > 0)];
    group.axis = stencil.axis;
    group.falls = stencil.towards[stencil.axis] > 0;
    group.periodic = grid_.periodic && stencil.axis != 2;
    group.counts = {grid_.size[b], grid_.size[c]};
    group.stride = strides[static_cast<std::size_t>(stencil.axis)];
    group.strides = {strides[static_cast<std::size_t>(b)], strides[static_cast<std::size_t>(c)]};
    group.paths.push_back({ordinates_[i], stencil, around[i]});
  }
  return groups;
}

void Sweeper::Hand::begin(const Group& group, std::span<const Moments> source, std::span<const Colours> crossing) {
  now_.resize(group.paths.size()), before_.resize(group.paths.size());
  for (std::vector<Plane>* planes : {&now_, &before_})
    for (Plane& plane : *planes) plane.radiance.resize(group.points()), plane.source.resize(group.points());
  extinction_.resize(group.points()), moments_.resize(group.points());
  if (group.periodic) load(group, source, group.falls ? 0 : grid_.size[group.axis] - 1);
  for (std::size_t i = 0; i < group.paths.size(); ++i) {
    if (group.periodic) {
      const auto crosses = crossing.subspan(i * group.points(), group.points());
      std::copy(crosses.begin(), crosses.end(), now_[i].radiance.begin());
    } else {
      std::fill(now_[i].radiance.begin(), now_[i].radiance.end(), group.paths[i].around);
      std::fill(now_[i].source.begin(), now_[i].source.end(), Colours{});
    }
  }
  if (!group.periodic) std::fill(extinction_.begin(), extinction_.end(), 0.0F);
  std::swap(now_, before_);
  extinction_before_ = extinction_;
}

void Sweeper::Hand::load(const Group& group, std::span<const Moments> source, int layer) {
  each_point(group, layer, [&](std::size_t point, std::size_t index) {
    moments_[point] = source[index];
    extinction_[point] = grid_.extinction_per_m[index];
  });
  for (std::size_t i = 0; i < group.paths.size(); ++i) {
    const glm::vec3& d = group.paths[i].ordinate.direction;
    const Colours x = all_of(d.x), y = all_of(d.y), z = all_of(d.z);
    for (std::size_t point = 0; point < moments_.size(); ++point) {
      const Moments& moments = moments_[point];
      now_[i].source[point] = moments.even + moments.east * x + moments.north * y + moments.up * z;
    }
  }
}

// Between two rows of the layer before, as the path meets it.
void Sweeper::Hand::mix_rows(const Plane& before, std::size_t row, std::size_t next_row, float share) {
  const Colours own = all_of(1 - share), next = all_of(share);
  for (std::size_t b = 0; b < mixed_.size(); ++b)
    mixed_[b] = {own * before.radiance[row + b] + next * before.radiance[next_row + b],
                 own * before.source[row + b] + next * before.source[next_row + b],
                 (1 - share) * extinction_before_[row + b] + share * extinction_before_[next_row + b]};
}

// Radiance in the points of a layer, from that in the layer before.
void Sweeper::Hand::cross(const Group& group, std::size_t number) {
  const Path& path = group.paths[number];
  Plane& now = now_[number];
  const auto [share_b, share_c] = path.stencil.shares;
  const Colours own = all_of(1 - share_b), next = all_of(share_b);
  const float half_m = 0.5F * path.stencil.length_m;
  const auto [axis_b, axis_c] = path.stencil.others;
  const auto [count_b, count_c] = group.counts;
  const bool wraps_b = grid_.periodic, wraps_c = grid_.periodic && axis_c != 2;
  mixed_.resize(static_cast<std::size_t>(count_b));
  for (int c = 0; c < count_c; ++c) {
    const Neighbour beside = neighbour_of(c, path.stencil.towards[axis_c], count_c);
    const std::size_t row = static_cast<std::size_t>(c * count_b);
    const bool outside = beside.out && !wraps_c;
    if (!outside) mix_rows(before_[number], row, static_cast<std::size_t>(beside.index * count_b), share_c);
    for (int b = 0; b < count_b; ++b) {
      const Neighbour ahead = neighbour_of(b, path.stencil.towards[axis_b], count_b);
      const std::size_t at = row + static_cast<std::size_t>(b);
      now.radiance[at] = path.around;
      if (outside || (ahead.out && !wraps_b)) continue;
      const Crossed &here = mixed_[static_cast<std::size_t>(b)], &there = mixed_[static_cast<std::size_t>(ahead.index)];
      const float extinction = extinction_[at] + (1 - share_b) * here.extinction + share_b * there.extinction;
      const Step step = step_of(half_m * extinction);
      now.radiance[at] = (own * here.radiance + next * there.radiance) * all_of(step.kept) +
                         (own * here.source + next * there.source) * all_of(step.far) +
                         now.source[at] * all_of(step.near);
    }
  }
}

// What has come to a layer, by all directions of the group.
void Sweeper::Hand::add(const Group& group, int layer) {
  std::fill(moments_.begin(), moments_.end(), Moments{});
  for (std::size_t i = 0; i < group.paths.size(); ++i) {
    const Ordinate& ordinate = group.paths[i].ordinate;
    const glm::vec3& d = ordinate.direction;
    const Colours weight = all_of(ordinate.weight), x = all_of(d.x), y = all_of(d.y), z = all_of(d.z);
    const std::vector<Colours>& radiance = now_[i].radiance;
    for (std::size_t point = 0; point < moments_.size(); ++point) {
      const Colours share = weight * radiance[point];
      Moments& sum = moments_[point];
      sum.even += share, sum.east += share * x, sum.north += share * y, sum.up += share * z;
    }
    // The mean over the layer of radiance times cosine, over the sphere.
    const Colours flux = all_of(12.566371F * ordinate.weight * d.z / static_cast<float>(grid_.size.x * grid_.size.y));
    const bool lies = group.axis == 2;  // else the lowest and the highest row of the layer count
    const auto row = [&](int height) { return lies ? 0 : static_cast<std::size_t>(height * group.counts[0]); };
    const int count = lies ? static_cast<int>(moments_.size()) : group.counts[0], top = grid_.size.z - 1;
    if (d.z > 0 && (!lies || layer == 0)) arrived_.down += flux * sum_of(radiance, row(0), count);
    if (d.z < 0 && (!lies || layer == top)) arrived_.up -= flux * sum_of(radiance, row(top), count);
  }
  each_point(group, layer, [&](std::size_t point, std::size_t index) {
    Moments& sum = arrived_.at[index];
    const Moments& part = moments_[point];
    sum.even += part.even, sum.east += part.east, sum.north += part.north, sum.up += part.up;
  });
}

void Sweeper::Hand::follow(const Group& group, std::span<const Moments> source, std::span<Colours> crossing) {
  begin(group, source, crossing);
  const int layers = grid_.size[group.axis];
  for (int i = 0; i < layers; ++i) {
    const int layer = group.falls ? layers - 1 - i : i;
    load(group, source, layer);
    for (std::size_t number = 0; number < group.paths.size(); ++number) cross(group, number);
    add(group, layer);
    std::swap(now_, before_), std::swap(extinction_, extinction_before_);
  }
  if (group.periodic)
    for (std::size_t i = 0; i < group.paths.size(); ++i)
      std::copy(before_[i].radiance.begin(), before_[i].radiance.end(),
                crossing.begin() + static_cast<std::ptrdiff_t>(i * group.points()));
}

std::size_t Sweeper::crossing_count() const {
  std::size_t count = 0;
  for (const Group& group : groups(std::vector<Colours>(ordinates_.size()))) count += group.crossing_count();
  return count;
}

// The same sums in the same order, however many processors there are.
Sweeper::Arrived Sweeper::sweep(std::span<const Moments> source, const std::vector<Colours>& around,
                                std::span<Colours> crossing) {
  const std::vector<Group> all = groups(around);
  const auto go = [&](bool falls) {
    Hand& hand = *hands_[falls];
    hand.begin_iteration(source.size());
    std::span<Colours> rest = crossing;
    for (const Group& group : all) {
      if (group.falls == falls && !group.paths.empty()) hand.follow(group, source, rest.first(group.crossing_count()));
      rest = rest.subspan(group.crossing_count());
    }
  };
  const std::future<void> falling = std::async(std::launch::async, go, true);
  go(false);
  falling.wait();
  Arrived arrived = hands_[0]->arrived();
  const Arrived& other = hands_[1]->arrived();
  for (std::size_t i = 0; i < arrived.at.size(); ++i) {
    Moments& sum = arrived.at[i];
    const Moments& part = other.at[i];
    sum.even += part.even, sum.east += part.east, sum.north += part.north, sum.up += part.up;
  }
  arrived.down += other.down, arrived.up += other.up;
  return arrived;
}

}  // namespace cloudscape::bake
