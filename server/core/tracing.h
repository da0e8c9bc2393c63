// How a path-traced picture is sampled: what a request of the quality `reference` can say beside its samples.
#pragma once
#include <cstdint>
#include <optional>

#include "core/fields.h"

namespace cloudscape {

// tables: paths see the air as every other picture does. traced: they are scattered in it.
enum class TracedAtmosphere { tables, traced };
template <>
struct EnumNames<TracedAtmosphere> {
  static constexpr std::array<std::string_view, 2> names{"tables", "traced"};
};

struct Tracing {
  std::uint32_t seed = 1;
  TracedAtmosphere atmosphere = TracedAtmosphere::tables;
  std::optional<int> max_scattering_order;
  std::optional<double> time_budget_s;
  std::optional<double> noise_target;
  bool operator==(const Tracing&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("seed", self.seed, Limits{0, 4294967295.0},
          "Of the random numbers of quality reference: the same seed gives the same picture, another an independent "
          "one.");
    visit("atmosphere", self.atmosphere, Limits{},
          "Quality reference: tables: air lies between the camera and what it sees, and lights the clouds, as the sky "
          "tables say. traced: paths are scattered in the air too, which makes no use of the tables but for how much "
          "sunlight the air lets through; only under a clear sky.");
    visit("max_scattering_order", self.max_scattering_order, Limits{1, 65535},
          "Quality reference: light that the clouds scattered more often is left out; 1: single scattering. What the "
          "air and the ground do is not counted. null: no limit.");
    visit("time_budget_s", self.time_budget_s, Limits{0.01, 1e6},
          "Quality reference: no sample is begun that would end after so many seconds of rendering; samples under way "
          "are finished. What comes out depends on the machine's speed, and is not reproducible. null: no limit.");
    visit("noise_target", self.noise_target, Limits{1e-5, 10},
          "Quality reference: stop when the root mean square of the pixels' standard errors is this share of the mean "
          "radiance. null: samples decides.");
  }
};

}  // namespace cloudscape
