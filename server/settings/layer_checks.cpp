#include "settings/layer_checks.h"

#include <cmath>

#include "core/error.h"
#include "settings/json_text.h"

namespace cloudscape::settings {
namespace {

// Altitudes from one to another, m.
struct Span {
  double bottom_m, top_m;
};

void check_altitude(const std::optional<double>& altitude_m, const Span& volume, const std::string& pointer) {
  if (!altitude_m || (*altitude_m >= volume.bottom_m && *altitude_m <= volume.top_m)) return;
  refuse(pointer, *altitude_m,
         "an altitude of the volume, from " + number_text(volume.bottom_m) + " to " + number_text(volume.top_m) +
             " m (volume.origin_m, volume.size_m)");
}

// What is thinner than two texels has no shape of its own.
void check_span(const std::optional<double>& bottom_m, const std::optional<double>& top_m, const Volume& volume,
                const std::string& pointer) {
  const Span all{volume.origin_m.z, volume.origin_m.z + volume.size_m.z};
  check_altitude(bottom_m, all, pointer + "/bottom_m");
  check_altitude(top_m, all, pointer + "/top_m");
  const Span own{bottom_m.value_or(all.bottom_m), top_m.value_or(all.top_m)};
  const double thickness_m = own.top_m - own.bottom_m, least_m = 2 * volume.size_m.z / volume.resolution;
  if (thickness_m >= least_m) return;
  throw InvalidInput(pointer, "lies from " + number_text(own.bottom_m) + " to " + number_text(own.top_m) +
                                  " m: must be at least " + number_text(least_m) +
                                  " m thick, two texels of the volume (volume.size_m, volume.resolution)");
}

}  // namespace

void check_octaves(const std::string& pointer, double finest_cells, const char* rule, int resolution,
                   const char* resolution_key) {
  if (finest_cells <= resolution) return;
  throw InvalidInput(pointer, "has " + number_text(finest_cells) + " cells a tile in its last octave (" + rule +
                                  "): must be at most " + resolution_key + ", " + number_text(resolution));
}

void check_layers(const Cloudscape& cloudscape, const std::string& pointer) {
  const Volume& volume = cloudscape.volume;
  const std::size_t count = cloudscape.layers.size();
  if (volume.kind != VolumeKind::noise) {
    if (count == 0) return;
    throw InvalidInput(pointer + "/layers", "has " + std::to_string(count) + (count == 1 ? " element" : " elements") +
                                                ": must be empty where volume.kind is " +
                                                std::string(name_of(volume.kind)) + ", since layers are of noise");
  }
  check_span(cloudscape.shape.bottom_m, cloudscape.shape.top_m, volume, pointer + "/shape");
  for (std::size_t i = 0; i < count; ++i) {
    const Layer& layer = cloudscape.layers[i];
    const std::string at = pointer + "/layers/" + std::to_string(i);
    check_span(layer.bottom_m, layer.top_m, volume, at);
    check_octaves(at + "/noise", layer.noise.frequency * std::pow(layer.noise.lacunarity, layer.noise.octaves - 1),
                  "frequency * lacunarity^(octaves - 1)", volume.resolution, "volume.resolution");
  }
}

}  // namespace cloudscape::settings
