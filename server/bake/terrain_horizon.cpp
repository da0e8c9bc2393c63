#include "bake/terrain_horizon.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cloudscape::bake {
namespace {

constexpr double planet_radius_m = 6360000;  // shaders/lib/constants.glsl
constexpr double farthest_m = 300'000;       // beyond it the planet hides every mountain
constexpr double sun_disc = 0.0093;          // its width, radians
constexpr float no_land = -0.2F;             // lower than any sun casts a shadow

// Lines along the axis that the azimuth is nearer to, in columns towards it: the lattice turned so that they go on to
// the right and up or down.
class Lines {
 public:
  explicit Lines(const HorizonProblem& problem)
      : problem_(problem),
        by_north_(std::abs(problem.towards.y) > std::abs(problem.towards.x)),
        along_(by_north_ ? problem.towards.y : problem.towards.x),
        slope_((by_north_ ? problem.towards.x : problem.towards.y) / std::abs(along_)),
        step_m_(problem.spacing_m / std::abs(along_)) {}

  double step_m() const { return step_m_; }
  double row_of(int line, int column) const { return line + slope_ * column; }
  // How many columns the next one lies before `column`. Far away a peak that is narrower than half the shadow's soft
  // edge, which the sun's disc (0.0093 radians) makes, hides nothing.
  int stride_at(int column) const { return std::max(1, static_cast<int>(0.5 * sun_disc * (column - problem_.side))); }
  int columns() const { return problem_.tiling ? static_cast<int>(farthest_m / step_m_) : problem_.side; }
  int first() const { return problem_.tiling ? 0 : -static_cast<int>(std::ceil(std::max(0.0, rise()))) - 1; }
  int end() const {
    return problem_.side + (problem_.tiling ? 0 : static_cast<int>(std::ceil(std::max(0.0, -rise()))) + 1);
  }
  // The index of a lattice point; -1: there is none.
  std::ptrdiff_t index(int column, int row) const {
    const int side = problem_.side;
    if (problem_.tiling)
      column &= side - 1, row &= side - 1;
    else if (row < 0 || row >= side)
      return -1;
    if (along_ < 0) column = side - 1 - column;
    const auto [x, y] = by_north_ ? std::pair(row, column) : std::pair(column, row);
    return std::ptrdiff_t{y} * side + x;
  }

 private:
  double rise() const { return slope_ * (problem_.side - 1); }  // over the whole map
  const HorizonProblem& problem_;
  bool by_north_;
  double along_, slope_, step_m_;
};

// What a line meets, from afar to near: only what something nearer does not hide from all that lies before it.
class Hull {
 public:
  struct Point {
    double x_m, z_m;
  };
  void clear() { points_.clear(); }
  void push(const Point& point) {
    while (points_.size() >= 2 && slope(point, points_[points_.size() - 2]) >= slope(point, points_.back()))
      points_.pop_back();
    points_.push_back(point);
  }
  // The steepest slope from a point before all of them; they fall off to both sides of it.
  double steepest_from(const Point& from) const {
    std::size_t low = 0, high = points_.size() - 1;
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (slope(from, points_[middle]) > slope(from, points_[middle + 1]))
        high = middle;
      else
        low = middle + 1;
    }
    return slope(from, points_[low]);
  }
  bool empty() const { return points_.empty(); }

 private:
  static double slope(const Point& from, const Point& to) { return (to.z_m - from.z_m) / (to.x_m - from.x_m); }
  std::vector<Point> points_;
};

class Horizon {
 public:
  explicit Horizon(const HorizonProblem& problem)
      : problem_(problem), lines_(problem), tangents_(problem.heights_m.size(), 0.0F), shares_(tangents_) {}

  std::vector<float> find(const std::stop_token& stop) {
    for (int line = lines_.first(); line < lines_.end(); ++line) {
      if (stop.stop_requested()) return {};
      follow(line);
    }
    for (std::size_t i = 0; i < tangents_.size(); ++i) tangents_[i] /= shares_[i];  // 1 but at a map's edges
    return std::move(tangents_);
  }

 private:
  // The planet falls away: heights above its tangent plane at the line's beginning.
  double above_plane_m(double height_m, double x_m) const { return height_m - x_m * x_m / (2 * planet_radius_m); }

  void follow(int line) {
    hull_.clear();
    for (int column = lines_.columns() - 1; column >= 0; column -= lines_.stride_at(column)) {
      const double row = lines_.row_of(line, column), x_m = column * lines_.step_m();
      const int below = static_cast<int>(std::floor(row));
      const double share = row - below;
      const std::ptrdiff_t low = lines_.index(column, below), high = share > 0 ? lines_.index(column, below + 1) : low;
      if (low < 0 || high < 0) continue;
      const double line_m = std::lerp(height_m(low), height_m(high), share);
      if (column < problem_.side) add(column, row, tangent_from(x_m, std::max(line_m, problem_.water_m)));
      hull_.push({x_m, above_plane_m(line_m, x_m)});
    }
  }

  double height_m(std::ptrdiff_t index) const { return problem_.heights_m[static_cast<std::size_t>(index)]; }

  double tangent_from(double x_m, double height_m) const {
    if (hull_.empty()) return no_land;
    return std::max<double>(no_land, hull_.steepest_from({x_m, above_plane_m(height_m, x_m)}) + x_m / planet_radius_m);
  }

  // What is seen from the line is what the lattice points to its sides see, as far as they are near it. (Not from their
  // own heights: across a slope the line lies higher or lower than they do.)
  void add(int column, double row, double tangent) {
    const int above = static_cast<int>(std::ceil(row));
    for (int point = above - 1; point <= above; ++point) {
      const std::ptrdiff_t index = lines_.index(column, point);
      const double share = 1 - std::abs(point - row);
      if (index < 0 || share <= 0) continue;
      tangents_[static_cast<std::size_t>(index)] += static_cast<float>(share * tangent);
      shares_[static_cast<std::size_t>(index)] += static_cast<float>(share);
    }
  }

  const HorizonProblem& problem_;
  Lines lines_;
  Hull hull_;
  std::vector<float> tangents_, shares_;
};

}  // namespace

std::vector<float> horizon_tangents(const HorizonProblem& problem, std::stop_token stop) {
  return Horizon(problem).find(stop);
}

}  // namespace cloudscape::bake
