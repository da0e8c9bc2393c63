// The techniques of the ray march, each of which can be switched: what a request starts from where it names none.
#pragma once
#include <optional>

#include "core/fields.h"

namespace cloudscape {

// UHawk, "Rendering volumetric clouds using signed distance fields"; Olajos 2.4.2 and 2.5. What is left to the quality
// (null) grows with the distance to the camera.
struct March {
  bool distance_field = true;
  bool structure = true;
  bool random_first_step = true;
  bool adaptive_step = false;
  double adaptive_start_m = 2000.0;
  double adaptive_growth = 0.05;
  std::optional<double> step_m;
  std::optional<double> large_step_m;
  std::optional<int> max_steps;
  double max_distance_m = 90000.0;
  bool lighting = true;
  std::optional<int> light_steps;
  std::optional<double> light_length_m;
  bool operator==(const March&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit(
        "distance_field", self.distance_field, Limits{},
        "Steps through clear air as long as a field of the distances to the nearest cloud allows (UHawk); false: those "
        "of `structure`.");
    visit("structure", self.structure, Limits{},
          "Large steps through the air that the low-resolution structure about the clouds leaves free (Olajos 2.4.2); "
          "false: small steps everywhere. Where there is no distance_field.");
    visit("random_first_step", self.random_first_step, Limits{},
          "The first step has a random length, so that steps that are too long show as noise and not as bands.");
    visit("adaptive_step", self.adaptive_step, Limits{},
          "Small steps grow with the distance from adaptive_start_m on.");
    visit("adaptive_start_m", self.adaptive_start_m, Limits{0, 1e6}, "Where the small steps begin to grow, m.");
    visit("adaptive_growth", self.adaptive_growth, Limits{0, 10}, "Growth of the small step for each metre beyond it.");
    visit(
        "step_m", self.step_m, Limits{0.1, 1e5},
        "Length of the small step, m, the same at every distance; null: the quality's, which grow with the distance.");
    visit("large_step_m", self.large_step_m, Limits{0.1, 1e5},
          "Length of the large step, m; never longer than the structure's padding makes safe. null: that.");
    visit("max_steps", self.max_steps, Limits{1, 16384},
          "Greatest number of steps of a ray, at most 65000 / (light_steps + 2); null: the quality's.");
    visit("max_distance_m", self.max_distance_m, Limits{1, 1e6}, "Where the march ends, m from the camera.");
    visit("lighting", self.lighting, Limits{},
          "Whether the sunlight is marched through the cloud; false: every point of it is lit alike.");
    visit("light_steps", self.light_steps, Limits{1, 128}, "Steps towards the sun; null: the quality's.");
    visit("light_length_m", self.light_length_m, Limits{1, 1e5},
          "How far the light is marched, m; null: by the layer's thickness.");
  }
};

}  // namespace cloudscape
