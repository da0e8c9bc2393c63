// The section of a cloudscape with the further layers of a noise volume.
#pragma once
#include <optional>

#include "core/cloudscape_volume.h"
#include "core/fields.h"

namespace cloudscape {

// One channel of noise, without a weight: there is nothing beside it.
struct LayerNoise {
  double worley_mix = 0.8;
  int frequency = 16;
  int octaves = 3;
  int lacunarity = 2;
  double gain = 0.5;
  bool operator==(const LayerNoise&) const = default;

  static void fields(auto& self, auto&& visit) { NoiseChannel::lattice_fields(self, visit); }
};

// Clouds of another kind in the same volume (UHawk: "a compute shader is run for each cloud layer and adds it"). What
// it does not say, as its medium and its detail, is the document's.
struct Layer {
  std::optional<double> bottom_m;
  std::optional<double> top_m;
  LayerNoise noise;
  double height_rise = 20.0;
  double height_fall = 2.0;
  double coverage = 0.45;
  double density = 1.0;
  bool operator==(const Layer&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("bottom_m", self.bottom_m, altitude_limits, "Lowest altitude of its clouds, m; null: the volume's bottom.");
    visit("top_m", self.top_m, altitude_limits, "Highest altitude of its clouds, m; null: the volume's top.");
    visit("noise", self.noise, Limits{}, "Its noise, with feature points of its own.");
    visit("height_rise", self.height_rise, Limits{0, 1000},
          "a of HD(h) = (1 - exp(-a h)) exp(-b h), where h is 0 at the layer's bottom and 1 at its top.");
    visit("height_fall", self.height_fall, Limits{0, 100}, "b of HD(h): how fast its clouds thin out upwards.");
    visit("coverage", self.coverage, Limits{0, 1}, "Share of the tile's columns that hold clouds of this layer.");
    visit("density", self.density, Limits{0, 1}, "Share of the medium's extinction that its clouds have.");
  }
};

}  // namespace cloudscape
