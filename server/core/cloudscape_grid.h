// The section of a cloudscape that names the file of a volume that others have made.
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

#include "core/fields.h"

namespace cloudscape {

enum class VoxelInterpolation { linear, nearest };
template <>
struct EnumNames<VoxelInterpolation> {
  static constexpr std::array<std::string_view, 2> names{"linear", "nearest"};
};

// file: where the file's own transform puts it. box: stretched over the volume's origin_m and size_m.
enum class GridPlacement { file, box };
template <>
struct EnumNames<GridPlacement> {
  static constexpr std::array<std::string_view, 2> names{"file", "box"};
};

enum class UpAxis { z, y };
template <>
struct EnumNames<UpAxis> {
  static constexpr std::array<std::string_view, 2> names{"z", "y"};
};

constexpr int max_grid_side = 512;  // voxels a side of the shape texture

// Density in voxels, from a file. Each voxel holds the density at its middle.
struct VolumeGrid {
  std::string file;
  std::string name = "density";
  double density_scale = 1.0;
  std::array<int, 3> size{64, 64, 64};
  int resolution = 256;
  bool tiling = false;
  VoxelInterpolation interpolation = VoxelInterpolation::linear;
  GridPlacement placement = GridPlacement::file;
  glm::dvec3 offset_m{0.0, 0.0, 0.0};
  double metres_per_unit = 1.0;
  UpAxis up = UpAxis::z;
  bool operator==(const VolumeGrid&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit(
        "file", self.file, Limits{0, 100},
        "Bare name in the folder of volumes: a .vdb (OpenVDB) for vdb; for grid a .raw (little-endian 32 bit floats, "
        "east fastest, then north, then up) or an .exr (horizontal slices side by side in ceil(sqrt(slices)) columns, "
        "north up; channel Y, or else R).");
    visit("name", self.name, Limits{1, 100}, "Name of the grid in the file; of vdb.");
    visit(
        "density_scale", self.density_scale, Limits{0, 1e6},
        "Density for each unit in the file; extinction is extinction_per_m times density, which here may be above 1.");
    visit("size", self.size, Limits{1, max_grid_side}, "Voxels east, north and up; of grid.");
    visit("resolution", self.resolution, Limits{1, max_grid_side},
          "Most voxels along the longest side; a larger grid is averaged down to it; of vdb.");
    visit("tiling", self.tiling, Limits{}, "Whether it repeats east and north to the horizon or stands alone.");
    visit("interpolation", self.interpolation, Limits{},
          "Between the voxels' middles; nearest: voxels are boxes with hard faces.");
    visit(
        "placement", self.placement, Limits{},
        "Where a vdb is. file: where its own transform says. box: stretched over origin_m and size_m, as a grid always "
        "is.");
    visit("offset_m", self.offset_m, Limits{-1e7, 1e7}, "Added to the file's own place (east, north, up), m.");
    visit("metres_per_unit", self.metres_per_unit, Limits{1e-6, 1e6}, "Metres to a unit of the file's own transform.");
    visit("up", self.up, Limits{},
          "The file's upward axis. z: x east, y north. y, as in Houdini and pbrt: x east, -z north.");
  }
};

namespace detail {
constexpr bool is_bare_name(std::string_view name) {
  for (const char c : name)
    if (c == '/' || c == '\\' || static_cast<unsigned char>(c) < 32) return false;
  return name.size() > 4 && name.front() != '.';
}
}  // namespace detail

// Whether a name can only mean a file in the folder of volumes: no path, nothing hidden, of the kind's own type.
constexpr bool is_vdb_name(std::string_view name) { return detail::is_bare_name(name) && name.ends_with(".vdb"); }
constexpr bool is_grid_name(std::string_view name) {
  return detail::is_bare_name(name) && (name.ends_with(".raw") || name.ends_with(".exr"));
}

}  // namespace cloudscape
