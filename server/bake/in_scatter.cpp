#include "bake/in_scatter.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>

#include "bake/anderson.h"
#include "bake/in_scatter_beam.h"
#include "bake/in_scatter_coarse.h"
#include "bake/in_scatter_sweep.h"

namespace cloudscape::bake {
namespace {

constexpr std::size_t accelerated_by = 4;  // tuned: results that are mixed; more help little and take memory
constexpr int smallest_halved = 10;        // tuned: points along an axis; smaller grids are quick as they are
constexpr float sphere = 4 * std::numbers::pi_v<float>;

// The part of the sphere that a direction lies in (shaders/render/light_directions.glsl).
std::size_t part_of(const glm::vec3& direction, const glm::dvec3& sun) {
  if (direction.z < 0) return 5;
  if (direction.z > 0.5F) return 0;
  const double right = direction.x * sun.y - direction.y * sun.x, ahead = direction.x * sun.x + direction.y * sun.y;
  if (std::abs(ahead) >= std::abs(right)) return ahead >= 0 ? 1 : 3;
  return right < 0 ? 2 : 4;
}

class Solver {
 public:
  explicit Solver(const InScatterProblem& problem) : problem_(problem), grid_(problem.grid), sweeper_(grid_) {
    const double f = problem.moments.forward_share, albedo = problem.single_scattering_albedo;
    for (float& extinction : grid_.extinction_per_m) extinction *= static_cast<float>(1 - albedo * f);
    albedo_ = static_cast<float>(albedo * (1 - f) / (1 - albedo * f));
    slope_ = static_cast<float>(3 * (problem.moments.asymmetry_g - f) / (1 - f));
    beam_ = beam_transmittance(grid_, problem.light.sun_direction);
    // The beam falls exponentially between the points: its mean about a point is more than its value there.
    const float length_m = stencil_of(glm::vec3(problem.light.sun_direction), grid_.spacing_m).length_m;
    for (const float extinction : grid_.extinction_per_m) {
      const float half = std::clamp(0.5F * extinction * length_m, 1e-3F, 4.0F);
      spread_.push_back(std::sinh(half) / half);
    }
  }

  InScatterSolution solve(std::vector<Colours> begin, const InScatterAccuracy& accuracy, std::stop_token stop) {
    InScatterSolution solution;
    std::vector<Colours> state = std::move(begin);
    Anderson anderson(accelerated_by);
    do {
      if (stop.stop_requested()) return solution;
      const std::vector<Colours> next = iterate(state, solution);
      solution.change = change(light_of(state), light_of(next));
      state = anderson.next(state, next);
      ++solution.iterations;
    } while (solution.change > accuracy.least_change && solution.iterations < accuracy.most_iterations);
    const std::span<const Moments> light = light_of(state);
    solution.light.assign(light.begin(), light.end());
    solution.beam = beam_;
    return solution;
  }

  // The state that an iteration begins with where the light is `light`, or dark if that is empty.
  std::vector<Colours> state_of(const std::vector<Moments>& light) const {
    std::vector<Colours> state(moments_count() + sweeper_.crossing_count() + 1);
    if (!light.empty()) std::memcpy(static_cast<void*>(state.data()), light.data(), light.size() * sizeof(Moments));
    state.back() = colours(problem_.light.surroundings[5]);
    return state;
  }

 private:
  // All that an iteration begins with: the moments of the light at the points, what crosses the sides, and the ground's
  // radiance.
  std::size_t moments_count() const { return 4 * beam_.size(); }
  std::span<const Moments> light_of(const std::vector<Colours>& state) const {
    return {reinterpret_cast<const Moments*>(state.data()), beam_.size()};
  }

  std::vector<Colours> iterate(const std::vector<Colours>& state, InScatterSolution& solution) {
    std::vector<Colours> next(state);
    const std::span<Colours> crossing = std::span(next).subspan(moments_count(), sweeper_.crossing_count());
    const Sweeper::Arrived arrived = sweeper_.sweep(sources(light_of(state)), around(state.back()), crossing);
    std::memcpy(static_cast<void*>(next.data()), arrived.at.data(), arrived.at.size() * sizeof(Moments));
    const float clear = std::max(1e-20F, luminance(clear_below()));
    solution.share_below = luminance(arrived.down + direct_below()) / clear;
    solution.share_above = luminance(arrived.up) / clear;
    next.back() = colours(problem_.light.surroundings[5]) * all_of(static_cast<float>(solution.share_below));
    return next;
  }

  Colours sun_at(std::size_t point) const { return colours(problem_.light.sun_irradiance[point / layer_points()]); }
  std::size_t layer_points() const {
    return static_cast<std::size_t>(grid_.size.x) * static_cast<std::size_t>(grid_.size.y);
  }

  std::vector<Moments> sources(std::span<const Moments> light) const {
    const glm::vec3 sun(problem_.light.sun_direction);
    const Colours even = all_of(albedo_), directed = all_of(albedo_ * slope_);
    std::vector<Moments> sources(light.size());
    for (std::size_t i = 0; i < light.size(); ++i) {
      const Colours beam = sun_at(i) * all_of(beam_[i] * spread_[i] / sphere);
      sources[i] = {even * (light[i].even + beam), directed * (light[i].east + beam * all_of(sun.x)),
                    directed * (light[i].north + beam * all_of(sun.y)),
                    directed * (light[i].up + beam * all_of(sun.z))};
    }
    return sources;
  }

  std::vector<Colours> around(const Colours& ground) const {
    std::vector<Colours> around;
    for (const Ordinate& each : sweeper_.directions()) {
      const std::size_t part = part_of(each.direction, problem_.light.sun_direction);
      around.push_back(part == 5 ? ground : colours(problem_.light.surroundings[part]));
    }
    return around;
  }

  // Flux of the sun's beam through the lowest layer, and that of all light from above without cloud.
  Colours direct_below() const {
    float sum = 0;
    for (std::size_t i = 0; i < layer_points(); ++i) sum += beam_[i];
    return sun_at(0) * all_of(sum / static_cast<float>(layer_points()) * slant());
  }
  Colours clear_below() const {
    Colours sum = sun_at(0) * all_of(slant());
    for (const Ordinate& each : sweeper_.directions())
      if (each.direction.z > 0)
        sum += colours(problem_.light.surroundings[part_of(each.direction, problem_.light.sun_direction)]) *
               all_of(sphere * each.weight * each.direction.z);
    return sum;
  }
  float slant() const { return std::max(0.0F, static_cast<float>(problem_.light.sun_direction.z)); }

  static double change(std::span<const Moments> before, std::span<const Moments> after) {
    double difference = 0, sum = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
      difference += std::abs(luminance(after[i].even - before[i].even));
      sum += std::abs(luminance(after[i].even));
    }
    return sum > 0 ? difference / sum : 0;
  }

  const InScatterProblem& problem_;
  InScatterGrid grid_;  // its extinction less what is scattered into the forward peak
  Sweeper sweeper_;
  float albedo_ = 1, slope_ = 0;  // of what is scattered elsewhere: albedo, three times its mean cosine
  std::vector<float> beam_, spread_;
};

}  // namespace

ScatterMoments scatter_moments(double asymmetry_g) {
  return {asymmetry_g, asymmetry_g > 0 ? asymmetry_g * asymmetry_g : 0};
}

std::optional<InScatterSolution> solve_in_scatter(const InScatterProblem& problem, const InScatterAccuracy& accuracy,
                                                  std::stop_token stop) {
  Solver solver(problem);
  std::vector<Moments> begin;
  const glm::ivec3& size = problem.grid.size;
  if (std::min({size.x, size.y, size.z}) >= smallest_halved) {
    const InScatterProblem coarse = coarse_problem(problem);
    const auto first = solve_in_scatter(coarse, {0.1 * accuracy.least_change, accuracy.most_iterations}, stop);
    if (!first) return std::nullopt;
    begin = refined(first->light, coarse.grid, problem.grid);
  }
  InScatterSolution solution = solver.solve(solver.state_of(begin), accuracy, stop);
  if (stop.stop_requested()) return std::nullopt;
  return solution;
}

}  // namespace cloudscape::bake
