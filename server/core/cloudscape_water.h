// The section of a cloudscape that says where water lies, and what it looks like.
#pragma once
#include <glm/vec3.hpp>
#include <optional>

#include "core/fields.h"

namespace cloudscape {

// A sea, or lakes: water all round the planet at one altitude, seen wherever no land stands above it.
struct Water {
  std::optional<double> level_m;
  double wind_m_per_s = 5.0;
  // Of a clear ocean: what its deep water scatters back (Mobley 1994, "Light and Water", section 3.8), seen by linear
  // sRGB.
  glm::dvec3 albedo{0.004, 0.018, 0.045};
  double clarity_m = 6.0;
  bool operator==(const Water&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("level_m", self.level_m, Limits{0, 8000}, "Altitude of the surface, m: 0 for a sea; null: no water.");
    visit("wind_m_per_s", self.wind_m_per_s, Limits{0, 30},
          "Wind over the water, m/s: makes its waves, whose mean square slope is 0.003 + 0.00512 wind (Cox and Munk "
          "1954), and less below 1 m/s; 0: a mirror. Waves run where `wind` blows to.");
    visit("albedo", self.albedo, Limits{0, 1}, "Diffuse reflectance of deep water (red, green, blue).");
    visit("clarity_m", self.clarity_m, Limits{0.05, 100},
          "Way in the water on which the light of the bottom of a shallow shore fades to 1 / e, m; red fades faster.");
  }
};

}  // namespace cloudscape
