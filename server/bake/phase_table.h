// A phase function of three colours as a table that the march looks up once a ray.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/fields.h"

namespace cloudscape::bake {

constexpr std::size_t phase_table_cells = 1536;  // between as many texels and one
constexpr std::size_t phase_table_texels = phase_table_cells + 1;

// What a table of water droplets depends on, and nothing else.
struct PhaseRecipe {
  int version = 1;  // of what computes it: raise it when that changes what it makes
  double effective_radius_um = 10.0;
  double effective_variance = 0.1;
  bool operator==(const PhaseRecipe&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("version", self.version, Limits{}, "");
    visit("effective_radius_um", self.effective_radius_um, Limits{}, "");
    visit("effective_variance", self.effective_variance, Limits{}, "");
  }
};
std::string phase_key(const PhaseRecipe& recipe);  // 64 hexadecimal characters

// Means over the droplets, weighted by their cross-sections.
struct DropletOptics {
  double extinction_efficiency = 0;
  double single_scattering_albedo = 0;
  double asymmetry_g = 0;
  bool operator==(const DropletOptics&) const = default;
};

struct PhaseTable {
  PhaseRecipe recipe;
  std::array<DropletOptics, 3> optics;              // red, green, blue
  std::array<std::vector<double>, 3> phase_per_sr;  // texel by texel
  bool operator==(const PhaseTable&) const = default;

  std::array<double, 3> at(double angle_rad) const;  // as the shader interpolates it, 1/sr
  double mean_asymmetry_g() const;
};

// Where a scattering angle (0: forward, to pi) lies in the table, 0..1: sqrt(t) / (1 + sqrt(t)) with t = tan(angle / 2)
// (shaders/lib/phase.glsl). Towards both ends cells shrink with the square root of the distance from the end, so that
// the forward peak and the glory are resolved at any droplet size; no cell is wider than 8 / phase_table_cells radians
// (0.3 degrees), and at the fog bow they are 0.2.
double phase_coordinate(double angle_rad);
double phase_angle_rad(double coordinate);

// As a sun of this angular radius shows it: each value becomes the mean over the sun's disc.
PhaseTable seen_by_disc(const PhaseTable& table, double sun_radius_rad);

}  // namespace cloudscape::bake
