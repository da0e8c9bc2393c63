// The section of a cloudscape that says how the medium interacts with light.
#pragma once
#include <array>
#include <glm/vec3.hpp>

#include "core/fields.h"

namespace cloudscape {

enum class PhaseKind { henyey_greenstein, two_lobe, rayleigh, isotropic, mie, none };
template <>
struct EnumNames<PhaseKind> {
  static constexpr std::array<std::string_view, 6> names{"henyey-greenstein", "two-lobe", "rayleigh",
                                                         "isotropic",         "mie",      "none"};
};

// cos_theta = 1 is forward scattering; the integral over all directions is 1.
struct Phase {
  PhaseKind kind = PhaseKind::henyey_greenstein;
  double asymmetry_g = 0.8;
  double second_asymmetry_g = -0.3;
  double second_weight = 0.3;
  double effective_radius_um = 10.0;
  double effective_variance = 0.1;
  bool operator==(const Phase&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("kind", self.kind, Limits{},
          "mie: of water droplets, computed by Lorenz-Mie theory. none: the same in all directions, as isotropic, but "
          "not looked up at all (Olajos, table 3.4).");
    visit("asymmetry_g", self.asymmetry_g, Limits{-0.99, 0.99}, "Mean cosine of the (first) Henyey-Greenstein lobe.");
    visit("second_asymmetry_g", self.second_asymmetry_g, Limits{-0.99, 0.99},
          "Mean cosine of the second lobe of two-lobe.");
    visit("second_weight", self.second_weight, Limits{0, 1}, "Share of the second lobe of two-lobe.");
    visit("effective_radius_um", self.effective_radius_um, Limits{1, 50},
          "Effective radius of the droplets of mie, micrometres.");
    visit("effective_variance", self.effective_variance, Limits{0.01, 0.5},
          "Effective variance of the droplets' radii (gamma distribution, Hansen 1971).");
  }
};

// single: Beer-Lambert, first order only. olajos: exp(-m d) (1 - exp(-c d)) (Olajos 2.5). beer_octaves: several
// attenuated, broadened copies of single scattering (Wrenninge 2013). beer_powder: 2 exp(-d) (1 - exp(-2 d))
// (Schneider and Vos 2015). in_scatter_volume: the first order as single has it, all others from a grid that they are
// solved on (server/bake/in_scatter.h).
enum class LightModelKind { single, olajos, beer_octaves, beer_powder, in_scatter_volume };
template <>
struct EnumNames<LightModelKind> {
  static constexpr std::array<std::string_view, 5> names{"single", "olajos", "beer-octaves", "beer-powder",
                                                         "in-scatter-volume"};
};

struct LightModel {
  LightModelKind kind = LightModelKind::in_scatter_volume;
  double olajos_attenuation = 0.25;
  double olajos_in_scatter = 2.0;
  double olajos_gain = 1.0;
  glm::dvec3 olajos_dark{0.10, 0.12, 0.15};
  glm::dvec3 olajos_bright{1.0, 1.0, 1.0};
  // Fitted to the light in spheres of optical radius 2.5 to 25 by a Monte Carlo calculation: right within a factor of 2
  // there, where half/half/half (Wrenninge 2013) is wrong by 15. The price: thin veils come out twice as bright.
  int octaves = 4;
  double octave_scattering = 0.534;
  double octave_extinction = 0.218;
  double octave_asymmetry = 0.684;
  int volume_resolution = 64;
  bool operator==(const LightModel&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("kind", self.kind, Limits{}, "What becomes of sunlight on its way to a point in the cloud.");
    visit("olajos_attenuation", self.olajos_attenuation, Limits{0, 10},
          "m, per unit of optical depth towards the sun.");
    visit("olajos_in_scatter", self.olajos_in_scatter, Limits{0, 100}, "c, per unit of optical depth towards the sun.");
    visit("olajos_gain", self.olajos_gain, Limits{0, 100},
          "Strength of the in-scattered light beside the first order.");
    visit(
        "olajos_dark", self.olajos_dark, Limits{0, 10},
        "Dark base colour of the cloud (red, green, blue), in place of the sky's light; 1: as a white diffuse surface "
        "in the sun.");
    visit("olajos_bright", self.olajos_bright, Limits{0, 10},
          "Bright colour that the light model adds to it (red, green, blue).");
    visit("octaves", self.octaves, Limits{1, 8}, "Octaves of beer-octaves, the first order included.");
    visit("octave_scattering", self.octave_scattering, Limits{0, 1}, "Contribution ratio of neighbouring octaves.");
    visit("octave_extinction", self.octave_extinction, Limits{0, 1}, "Extinction ratio of neighbouring octaves.");
    visit("octave_asymmetry", self.octave_asymmetry, Limits{0, 1}, "Asymmetry ratio of neighbouring octaves.");
    visit("volume_resolution", self.volume_resolution, Limits{8, 64, true},
          "Points of the in-scatter-volume along a side of the tile, 64 at most; half as many take an eighth of the "
          "time to solve.");
  }
};

struct Medium {
  double extinction_per_m = 0.06;  // 0.4 g/m3 of water in droplets of 10 um: 3 LWC Qext / (4 rho r)

  double single_scattering_albedo = 1.0;
  double ambient = 1.0;
  Phase phase;
  LightModel light_model;
  bool operator==(const Medium&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("extinction_per_m", self.extinction_per_m, Limits{0, 10}, "Extinction coefficient where density is 1, 1/m.");
    visit("single_scattering_albedo", self.single_scattering_albedo, Limits{0, 1}, "Scattering over extinction.");
    visit("ambient", self.ambient, Limits{0, 10},
          "Scale of the light from the sky above and the ground below; 0: none.");
    visit("phase", self.phase, Limits{}, "Phase function and its parameters.");
    visit("light_model", self.light_model, Limits{}, "Sunlight inside the cloud.");
  }
};

}  // namespace cloudscape
