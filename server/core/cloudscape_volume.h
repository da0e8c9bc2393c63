// The sections of a cloudscape that say where the medium is and what shape it has.
#pragma once
#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/cloudscape_grid.h"
#include "core/fields.h"

namespace cloudscape {

// noise: clouds carved from baked noise. vdb, grid: voxels from a file. The others are homogeneous media with
// closed-form answers, for checks and teaching.
enum class VolumeKind { noise, sphere, box, slab, gaussian, vdb, grid };
template <>
struct EnumNames<VolumeKind> {
  static constexpr std::array<std::string_view, 7> names{"noise", "sphere", "box", "slab", "gaussian", "vdb", "grid"};
};
constexpr bool is_from_file(VolumeKind kind) { return kind == VolumeKind::vdb || kind == VolumeKind::grid; }

// rgba8: the shape and three finer noises, mixed when they are sampled. r16f: the mixed shape alone, of 16 bits.
enum class VolumeFormat { rgba8, r16f };
template <>
struct EnumNames<VolumeFormat> {
  static constexpr std::array<std::string_view, 2> names{"rgba8", "r16f"};
};

struct Volume {
  VolumeKind kind = VolumeKind::noise;
  glm::dvec3 origin_m{0.0, 0.0, 1000.0};
  glm::dvec3 size_m{8000.0, 8000.0, 2000.0};
  int resolution = 128;
  bool tiling = true;
  VolumeFormat format = VolumeFormat::rgba8;
  VolumeGrid grid;
  bool operator==(const Volume&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("kind", self.kind, Limits{},
          "noise: a layer that bends with the planet. sphere: a ball as wide as size_m[0] in the middle of the box. "
          "box: the "
          "whole box. slab: between the box's bottom and top, without end. gaussian: density exp(-r^2 / (2 s^2)) about "
          "the "
          "middle of the box, s = size_m[0] / 8, cut off at the box. vdb, grid: voxels from a file. All but noise are "
          "flat.");
    visit("origin_m", self.origin_m, Limits{-1e7, 1e7}, "South-west lower corner (east, north, altitude), m.");
    visit("size_m", self.size_m, Limits{1, 1e6}, "Extent (east, north, up), m; the period of a tiling volume.");
    visit("resolution", self.resolution, Limits{16, 512, true},
          "Texels a side of the baked shape texture; a power of two.");
    visit("tiling", self.tiling, Limits{}, "Whether a noise volume repeats to the horizon or stands alone.");
    visit("format", self.format, Limits{},
          "Texels of the shape texture. rgba8: four noises of 8 bits, mixed by their weights when they are sampled. "
          "r16f: "
          "mixed when they are baked, one number of 16 bits; half the memory, and a new bake for each change of a "
          "weight. With `layers` neither: coverage and density, two numbers of 16 bits.");
    visit("grid", self.grid, Limits{}, "The voxels of vdb and grid.");
  }
};

struct NoiseChannel {
  double worley_mix = 1.0;
  int frequency = 4;
  int octaves = 3;
  int lacunarity = 2;
  double gain = 0.5;
  double weight = 1.0;
  bool operator==(const NoiseChannel&) const = default;

  static void fields(auto& self, auto&& visit) {
    lattice_fields(self, visit);
    visit(
        "weight", self.weight, Limits{0, 4},
        "How much the channel adds to the shape when it is sampled; the first channel is the shape and has weight 1.");
  }

  // Those that every noise has.
  static void lattice_fields(auto& self, auto&& visit) {
    visit("worley_mix", self.worley_mix, Limits{0, 1}, "0: Perlin noise, 1: Worley noise, between: both mixed.");
    visit("frequency", self.frequency, Limits{1, 128, true},
          "Lattice cells along the tile's width in the first octave; a power of two. Upwards: as many as make them as "
          "high as wide.");
    visit("octaves", self.octaves, Limits{1, 8}, "Octaves of fractional Brownian motion.");
    visit("lacunarity", self.lacunarity, Limits{2, 8, true},
          "Frequency ratio of neighbouring octaves; a power of two.");
    visit("gain", self.gain, Limits{0, 1}, "Amplitude ratio of neighbouring octaves.");
  }
};

struct Noise {
  std::array<NoiseChannel, 4> channels{NoiseChannel{0.7, 4, 3, 2, 0.45, 1.0}, NoiseChannel{1.0, 16, 3, 2, 0.5, 0.9},
                                       NoiseChannel{1.0, 32, 2, 2, 0.5, 0.5}, NoiseChannel{1.0, 64, 1, 2, 0.5, 0.3}};
  bool operator==(const Noise&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("channels", self.channels, Limits{}, "Red, green, blue and alpha of the shape texture.");
  }
};

// A bell of cloud: height(u, v) = top exp(-d^2 / (2 radius^2)), Olajos 2.3.2. Tile units: 0..1 across the volume.
struct Tower {
  glm::dvec2 center{0.5, 0.5};
  double radius = 0.08;
  double top = 0.9;
  double strength = 0.5;
  bool operator==(const Tower&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("center", self.center, Limits{0, 1}, "East and north in the tile, 0 to 1.");
    visit("radius", self.radius, Limits{0.005, 0.5}, "Standard deviation of the bell, in tiles.");
    visit("top", self.top, Limits{0, 1}, "Height of the bell in the volume, 0 to 1.");
    visit("strength", self.strength, Limits{0, 2}, "What the tower adds to the shape noise at its axis.");
  }
};

struct CoverageVariation {
  double amount = 0.0;
  double wavelength_m = 40000.0;
  bool operator==(const CoverageVariation&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("amount", self.amount, Limits{0, 1}, "How far the threshold swings over the land; 0: not at all.");
    visit("wavelength_m", self.wavelength_m, Limits{1000, 1e6}, "Typical distance of clearings, m.");
  }
};

constexpr Limits altitude_limits{-1e7, 1e7};  // as of the volume's origin

struct Shape {
  double height_rise = 50.0;
  double height_fall = 4.0;
  double coverage = 0.45;
  std::optional<double> threshold;
  double edge_softness = 0.02;
  CoverageVariation coverage_variation;
  std::vector<Tower> towers;
  std::optional<double> bottom_m;
  std::optional<double> top_m;
  double density = 1.0;
  bool operator==(const Shape&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("height_rise", self.height_rise, Limits{0, 1000},
          "a of HD(h) = (1 - exp(-a h)) exp(-b h), Olajos 2.3.1: flat bases.");
    visit("height_fall", self.height_fall, Limits{0, 100}, "b of HD(h): how fast clouds thin out upwards.");
    visit("coverage", self.coverage, Limits{0, 1}, "Share of the tile's columns that hold cloud; sets the threshold.");
    visit("threshold", self.threshold, Limits{0, 2}, "Cut-off of the shape noise (Olajos 2.3.3); null: from coverage.");
    visit("edge_softness", self.edge_softness, Limits{0.001, 1},
          "Shape noise above the threshold at which density reaches 1.");
    visit("coverage_variation", self.coverage_variation, Limits{},
          "Slow change of coverage over the land; hides the tiling.");
    visit("towers", self.towers, Limits{0, 32}, "Gaussian towers, 32 at most (Olajos 2.3.2).");
    visit("bottom_m", self.bottom_m, altitude_limits,
          "Lowest altitude of these clouds, as other `layers` have theirs, m; null: the volume's bottom.");
    visit("top_m", self.top_m, altitude_limits, "Highest altitude of these clouds, m; null: the volume's top.");
    visit("density", self.density, Limits{0, 1}, "Share of the medium's extinction that these clouds have.");
  }
};

struct Detail {
  int resolution = 32;
  int frequency = 4;
  int octaves = 3;
  double period_m = 500.0;
  double strength = 0.14;
  bool operator==(const Detail&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("resolution", self.resolution, Limits{16, 64, true}, "Texels a side; 32 or 64 are useful.");
    visit("frequency", self.frequency, Limits{1, 16, true}, "Worley cells a tile of the first octave; a power of two.");
    visit("octaves", self.octaves, Limits{1, 5}, "Octaves of fractional Brownian motion.");
    visit("period_m", self.period_m, Limits{10, 100000}, "Size of the detail tile, m.");
    visit("strength", self.strength, Limits{0, 1}, "Shape noise that it takes off at most, at the edges; 0: none.");
  }
};

}  // namespace cloudscape
