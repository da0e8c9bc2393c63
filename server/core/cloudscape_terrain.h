// The section of a cloudscape that says how high the land is, and what covers it.
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

#include "core/fields.h"

namespace cloudscape {

// Heights on a square lattice of resolution^2 points, bilinear in between, from noise or from a picture.
struct Terrain {
  std::string height_map;
  int resolution = 1024;
  double size_m = 32000.0;
  glm::dvec2 origin_m{0.0, 0.0};
  double base_m = 0.0;
  double height_m = 2600.0;
  bool tiling = true;
  int seed = 0;
  double feature_m = 10000.0;
  int octaves = 7;
  double roughness = 0.55;
  double erosion = 0.6;
  double snow_line_m = 2000.0;
  double tree_line_m = 1300.0;
  double rock_slope_deg = 34.0;
  glm::dvec3 rock_albedo{0.19, 0.175, 0.16};
  glm::dvec3 snow_albedo{0.80, 0.83, 0.88};
  bool operator==(const Terrain&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit(
        "height_map", self.height_map, Limits{0, 100},
        "Bare name of a .png (8 or 16 bit grey) or .exr (one float channel) in the folder of height maps, its top row "
        "north, stretched over the square; empty: heights are made from noise.");
    visit("resolution", self.resolution, Limits{64, 4096, true},
          "Points of the height lattice a side; a power of two.");
    visit("size_m", self.size_m, Limits{100, 1e6}, "Edge of the square, m; its period where it tiles.");
    visit("origin_m", self.origin_m, Limits{-1e7, 1e7}, "South-west corner (east, north), m.");
    visit("base_m", self.base_m, Limits{0, 8000}, "Altitude of height 0, and of the plain about a single map, m.");
    visit("height_m", self.height_m, Limits{0, 12000},
          "Height above base_m of 1 in the map (white in a PNG), and of the highest peak of noise, m; 1 for an EXR in "
          "metres.");
    visit("tiling", self.tiling, Limits{},
          "Whether the map repeats to the horizon; false: it stands alone, its outer tenth going down to the plain.");
    visit("seed", self.seed, Limits{0, 1e9},
          "Added to the document's seed, for other mountains under the same clouds.");
    visit("feature_m", self.feature_m, Limits{100, 1e6},
          "Size of the largest mountains of noise, m; size_m is cut into whole ones.");
    visit("octaves", self.octaves, Limits{1, 10},
          "Octaves of gullies and rocks, each half as large as the one before.");
    visit("roughness", self.roughness, Limits{0.2, 0.8}, "How high an octave is beside the one before.");
    visit("erosion", self.erosion, Limits{0, 1}, "How deep water has cut gullies into the slopes of noise.");
    visit("snow_line_m", self.snow_line_m, Limits{-1000, 20000}, "Altitude above which snow lies, m.");
    visit("tree_line_m", self.tree_line_m, Limits{-1000, 20000}, "Altitude up to which ground.albedo covers it, m.");
    visit("rock_slope_deg", self.rock_slope_deg, Limits{5, 89}, "Slope above which rock is bare, degrees.");
    visit("rock_albedo", self.rock_albedo, Limits{0, 1}, "Diffuse reflectance of rock (red, green, blue).");
    visit("snow_albedo", self.snow_albedo, Limits{0, 1}, "Diffuse reflectance of snow (red, green, blue).");
  }
};

// Whether a name can only mean a file in the folder of height maps: no path, nothing hidden, .png or .exr.
inline bool is_height_map_name(std::string_view name) {
  for (const char c : name)
    if (c == '/' || c == '\\' || static_cast<unsigned char>(c) < 32) return false;
  return name.size() > 4 && name.front() != '.' && (name.ends_with(".png") || name.ends_with(".exr"));
}

}  // namespace cloudscape
