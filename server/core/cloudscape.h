// The cloudscape document as plain values: what the sky is. World frame: x east, y north, z up, metres, origin at sea
// level. Immutable once made; comparable; `content_hash` (content_hash.h) names it. The sections stand in headers of
// their own.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/cloudscape_environment.h"
#include "core/cloudscape_layers.h"
#include "core/cloudscape_medium.h"
#include "core/cloudscape_volume.h"
#include "core/view.h"

namespace cloudscape {

struct Cloudscape {
  std::string title;
  std::string description;
  std::uint32_t seed = 1;
  Volume volume;
  Noise noise;
  Shape shape;
  std::vector<Layer> layers;
  Detail detail;
  Medium medium;
  Sun sun;
  Moon moon;
  Sky sky;
  Ground ground;
  Wind wind;
  View view;
  bool operator==(const Cloudscape&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("title", self.title, Limits{0, 80}, "Short name for people.");
    visit("description", self.description, Limits{0, 500}, "One sentence about the sky that it shows.");
    visit("seed", self.seed, Limits{0, 4294967295.0}, "Seed of every random choice of the bake.");
    visit("volume", self.volume, Limits{}, "Where the medium is.");
    visit("noise", self.noise, Limits{}, "The four channels of the shape texture (Olajos 2.2).");
    visit("shape", self.shape, Limits{}, "How noise becomes clouds (Olajos 2.3).");
    visit("layers", self.layers, Limits{0, 4},
          "Further layers of clouds in a noise volume, of other kinds, 4 at most; they are added to those of `shape` "
          "when these are baked, and so a change of a coverage needs a new bake.");
    visit("detail", self.detail, Limits{}, "The fine texture that erodes the clouds' edges.");
    visit("medium", self.medium, Limits{}, "Optical properties of the cloud.");
    visit("sun", self.sun, Limits{}, "Direction and strength of the sun.");
    visit("moon", self.moon, Limits{}, "Where the moon stands; it lights the night.");
    visit("sky", self.sky, Limits{}, "The sky behind and above the clouds.");
    visit("ground", self.ground, Limits{}, "The planet's surface.");
    visit("wind", self.wind, Limits{}, "How the clouds move with time.");
    visit("view", self.view, Limits{}, "Camera and display that a request starts from where it names none.");
  }
};

// Whether its shape texture holds several layers, or one that is not simply all of the volume.
constexpr bool is_layered(const Cloudscape& sky) {
  const Shape& own = sky.shape;
  return sky.volume.kind == VolumeKind::noise && (!sky.layers.empty() || own.bottom_m || own.top_m || own.density != 1);
}

// Shape noise that erosion takes off on average; the device's mean of it (shaders/render/medium.glsl) is a half.
constexpr double mean_erosion(const Cloudscape& sky) { return 0.5 * sky.detail.strength; }

}  // namespace cloudscape
