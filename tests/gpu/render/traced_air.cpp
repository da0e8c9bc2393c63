#include "traced_air.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace cloudscape::render {
namespace {

using glm::dvec3;
constexpr double pi = std::numbers::pi, ground_m = 6360e3, top_m = 6460e3, asymmetry = 0.8;
constexpr double rayleigh_per_m[] = {7.18e-6, 13.73e-6, 32.22e-6}, ozone_per_m[] = {2.487e-6, 1.795e-6, 0};

struct Coefficients {
  double rayleigh, aerosol, extinction;
};

Coefficients at(const TracedAir& air, int channel, const dvec3& p) {
  const double h = std::max(0.0, glm::length(p) - ground_m);
  const double rayleigh = rayleigh_per_m[channel] * std::exp(-h / 8000), aerosol = air.haze * std::exp(-h / 1200);
  const double ozone = ozone_per_m[channel] * std::max(0.0, 1 - std::abs(h - 25000) / 15000);
  return {rayleigh, 3.996e-6 * aerosol, rayleigh + 4.44e-6 * aerosol + ozone};
}

// Distance to a sphere about the planet's middle; negative: none ahead.
double to_sphere(const dvec3& p, const dvec3& d, double radius, bool nearer) {
  const double b = glm::dot(p, d), discriminant = b * b - glm::dot(p, p) + radius * radius;
  if (discriminant < 0) return -1;
  return nearer ? -b - std::sqrt(discriminant) : -b + std::sqrt(discriminant);
}

bool meets_ground(const dvec3& p, const dvec3& d) { return to_sphere(p, d, ground_m, true) > 1e-3; }

double optical_depth(const TracedAir& air, int channel, const dvec3& p, const dvec3& d, double length_m, int steps) {
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double low = double(i) / steps, high = double(i + 1) / steps;
    const double step_m = length_m * (high * high - low * low);
    sum += step_m * at(air, channel, p + d * (0.5 * length_m * (high * high + low * low))).extinction;
  }
  return sum;
}

double to_sun(const TracedAir& air, int channel, const dvec3& p) {
  if (meets_ground(p, air.sun)) return 0;
  return std::exp(-optical_depth(air, channel, p, air.sun, to_sphere(p, air.sun, top_m, false), 60));
}

double phase_rayleigh(double c) { return 3 / (16 * pi) * (1 + c * c); }
double phase_aerosol(double c) {
  const double g = asymmetry, d = 1 + g * g - 2 * g * c;
  return 3 / (8 * pi) * (1 - g * g) * (1 + c * c) / ((2 + g * g) * d * std::sqrt(d));
}

class Path {
 public:
  Path(const TracedAir& air, int channel, double farthest_m, std::uint64_t seed)
      : air_(air), channel_(channel), farthest_m_(farthest_m), random_(seed) {}

  double radiance(const dvec3& start, const dvec3& direction) {
    sum_ = 0;
    p_ = start, d_ = direction, on_ground_ = false;
    first_collision();
    go_on();
    if (!ends_on_ground_ || air_.albedo <= 0) return sum_;
    p_ = start + direction * length_m_, d_ = direction;
    weight_ = std::exp(-table_.back()), on_ground_ = true;
    go_on();
    return sum_;
  }

 private:
  void go_on() {
    for (int order = 1; order <= air_.most_orders; ++order) {
      if (!scatter(order == air_.most_orders) || !fly()) break;
      if (order > 3) {  // Russian roulette
        const double survives = std::min(1.0, weight_);
        if (uniform() >= survives) break;
        weight_ /= survives;
      }
    }
  }

  double uniform() { return std::uniform_real_distribution<double>(0, 1)(random_); }

  // The first collision is forced, its place found in a table of the optical depth along the ray.
  void first_collision() {
    constexpr int cells = 2000;
    if (table_.empty()) {
      const bool down = meets_ground(p_, d_);
      const double whole_m = down ? to_sphere(p_, d_, ground_m, true) : to_sphere(p_, d_, top_m, false);
      length_m_ = std::min(whole_m, farthest_m_);
      ends_on_ground_ = down && whole_m <= farthest_m_;
      table_.push_back(0);
      for (int i = 0; i < cells; ++i) {
        const double low = place(i, cells), high = place(i + 1, cells);
        table_.push_back(table_.back() + (high - low) * at(air_, channel_, p_ + d_ * (0.5 * (low + high))).extinction);
      }
    }
    const double share = 1 - std::exp(-table_.back());
    const double depth = -std::log(1 - uniform() * share);
    const auto above = std::upper_bound(table_.begin() + 1, table_.end() - 1, depth);
    const int cell = static_cast<int>(above - table_.begin()) - 1;
    const double part = (depth - table_[cell]) / (table_[cell + 1] - table_[cell]);
    p_ += d_ * std::lerp(place(cell, cells), place(cell + 1, cells), part);
    weight_ = share;
  }
  double place(int i, int cells) const { return length_m_ * i / cells; }

  bool scatter(bool last) {
    if (on_ground_) return reflect();
    const Coefficients here = at(air_, channel_, p_);
    weight_ *= (here.rayleigh + here.aerosol) / here.extinction;
    const bool rayleigh = uniform() * (here.rayleigh + here.aerosol) < here.rayleigh;
    const double cosine = glm::dot(d_, air_.sun);
    sum_ += weight_ * (rayleigh ? phase_rayleigh(cosine) : phase_aerosol(cosine)) * to_sun(air_, channel_, p_);
    if (!last) turn(rayleigh);
    return !last;
  }

  bool reflect() {
    on_ground_ = false;
    const dvec3 up = glm::normalize(p_);
    weight_ *= air_.albedo;
    const double mu = glm::dot(up, air_.sun);
    if (mu > 0) sum_ += weight_ * mu / pi * to_sun(air_, channel_, p_ + up * 0.01);
    p_ += up * 0.01;
    set_direction(up, std::sqrt(uniform()));
    return weight_ > 0;
  }

  void turn(bool rayleigh) {
    double c;
    if (rayleigh) {
      do c = 2 * uniform() - 1;
      while (2 * uniform() > 1 + c * c);
    } else {
      const double g = asymmetry, s = (1 - g * g) / (1 - g + 2 * g * uniform());
      c = (1 + g * g - s * s) / (2 * g);
      weight_ *= 1.5 * (1 + c * c) / (2 + g * g);  // Cornette and Shanks over Henyey and Greenstein
    }
    set_direction(d_, c);
  }

  void set_direction(const dvec3& axis, double cosine) {
    const dvec3 side = glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.9 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
    const double angle = 2 * pi * uniform(), sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    d_ = cosine * axis + sine * (std::cos(angle) * side + std::sin(angle) * glm::cross(axis, side));
  }

  // To the next collision, with the air or the ground; false: out into space.
  bool fly() {
    const double most_per_m = rayleigh_per_m[channel_] + 4.44e-6 * air_.haze;
    const bool down = meets_ground(p_, d_);
    const double end_m = down ? to_sphere(p_, d_, ground_m, true) : to_sphere(p_, d_, top_m, false);
    for (double t = 0;;) {
      t -= std::log(1 - uniform()) / most_per_m;
      if (t >= end_m) {
        p_ += d_ * end_m;
        on_ground_ = down;
        return down && air_.albedo > 0;
      }
      if (uniform() * most_per_m >= at(air_, channel_, p_ + d_ * t).extinction) continue;
      p_ += d_ * t;
      return true;
    }
  }

  const TracedAir& air_;
  int channel_;
  double farthest_m_;
  std::mt19937_64 random_;
  dvec3 p_{0}, d_{0};
  double weight_ = 1, sum_ = 0, length_m_ = 0;
  bool on_ground_ = false, ends_on_ground_ = false;
  std::vector<double> table_;
};

}  // namespace

TracedRadiance traced_sky(const TracedAir& air, double altitude_m, const dvec3& direction, int paths,
                          double distance_m) {
  TracedRadiance result{};
  for (int channel = 0; channel < 3; ++channel) {
    Path path(air, channel, distance_m, 1 + static_cast<std::uint64_t>(channel));
    double sum = 0, squares = 0;
    for (int i = 0; i < paths; ++i) {
      const double value = path.radiance({0, 0, ground_m + altitude_m}, direction);
      sum += value, squares += value * value;
    }
    result.mean[channel] = sum / paths;
    result.error[channel] = std::sqrt(std::max(0.0, squares / paths - sum * sum / paths / paths) / paths);
  }
  return result;
}

}  // namespace cloudscape::render
