// What the bake of one layer of several depends on.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/cloudscape.h"

namespace cloudscape::bake {

struct LayerRecipe {
  std::uint32_t seed = 1;
  Noise noise;  // mixed by the weights
  double height_rise = 50, height_fall = 4;
  std::vector<Tower> towers;
  double bottom = 0, top = 1;  // heights in the volume, 0..1
  double coverage = 0.45;
  std::optional<double> threshold;  // instead of the coverage's
  double density = 1;
  bool operator==(const LayerRecipe&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("seed", self.seed, Limits{}, "");
    visit("noise", self.noise, Limits{}, "");
    visit("height_rise", self.height_rise, Limits{}, "");
    visit("height_fall", self.height_fall, Limits{}, "");
    visit("towers", self.towers, Limits{}, "");
    visit("bottom", self.bottom, Limits{}, "");
    visit("top", self.top, Limits{}, "");
    visit("coverage", self.coverage, Limits{}, "");
    visit("threshold", self.threshold, Limits{}, "");
    visit("density", self.density, Limits{}, "");
  }
};

// Of a layered document: the one of `shape` first, then those of `layers`.
std::vector<LayerRecipe> layer_recipes(const Cloudscape& cloudscape);

}  // namespace cloudscape::bake
