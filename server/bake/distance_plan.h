// For which clouds a distance field is built (bake/distance_field.h).
#pragma once
#include <array>
#include <glm/vec3.hpp>

#include "core/fields.h"

namespace cloudscape::bake {

// Coverage that varies over the land moves the threshold from level to level.
struct DistancePlan {
  std::array<double, 3> weights{};  // the shape's finer channels are mixed in with
  glm::dvec3 size_m{1};             // of the tile
  double lowest_threshold = 0;      // below it none is anywhere
  double between_levels = 1;        // of the threshold
  int levels = 1;                   // up to most_distance_levels
  double threshold_fall_per_m = 0;  // how fast the threshold can fall, or rise, along a way
  bool jumps = false;               // whether the shape is looked up without interpolation
  bool operator==(const DistancePlan&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("weights", self.weights, Limits{}, "");
    visit("size_m", self.size_m, Limits{}, "");
    visit("lowest_threshold", self.lowest_threshold, Limits{}, "");
    visit("between_levels", self.between_levels, Limits{}, "");
    visit("levels", self.levels, Limits{}, "");
    visit("threshold_fall_per_m", self.threshold_fall_per_m, Limits{}, "");
    visit("jumps", self.jumps, Limits{}, "");
  }
};

constexpr int most_distance_levels = 4;  // tuned: more enclose less, and take as long again to build

// Its levels, for thresholds from `least` to `greatest`.
DistancePlan distance_plan(double least, double greatest);

}  // namespace cloudscape::bake
