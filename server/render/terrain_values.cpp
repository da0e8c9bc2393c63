// The terrain block: the lattice as one camera sees it, and what covers the land.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "render/block_values.h"
#include "render/terrain_stage.h"

namespace cloudscape::render {
namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;

double wrapped(double value, double period) { return value - period * std::floor(value / period); }

vec4 xyz_w(const glm::dvec3& xyz, double w) { return {xyz.x, xyz.y, xyz.z, w}; }

}  // namespace

// Width of what a sample stands for in the middle of the picture: that of parallel rays (m), and growth for each metre
// of distance.
glm::dvec2 pixel_widths(const FrameRequest& request) {
  const double width = request.size_px.width / request.sample_share;
  const double height = request.size_px.height / request.sample_share;
  switch (request.lens.kind) {
    case LensKind::perspective:
      return {0, 2 * std::tan(0.5 * request.lens.vertical_fov_deg * radians_per_degree) / height};
    case LensKind::orthographic:
      return {request.lens.width_m / width, 0};
    case LensKind::panorama:
      return {0, std::numbers::pi / height};
    case LensKind::fisheye:
      return {0, std::numbers::pi / std::min(width, height)};
  }
  return {0, 0};
}

TerrainBlock terrain_block(const FrameRequest& request, const bake::BakedTerrain& baked) {
  const Terrain& terrain = request.cloudscape->ground.terrain;
  const Sun& sun = request.cloudscape->sun;
  const glm::dvec2 camera_m(request.pose.position_m), corner_m = terrain.origin_m - camera_m;
  const int side = baked.recipe().resolution;
  const double spacing_m = terrain.size_m / side;
  glm::dvec2 at = -corner_m / spacing_m;
  if (terrain.tiling) at = {wrapped(at.x, side), wrapped(at.y, side)};
  const glm::dvec2 width = pixel_widths(request);
  const glm::dvec3 towards_sun = direction_of(light_azimuth_deg(*request.cloudscape), 0);
  TerrainBlock block;
  block.lattice = {1 / spacing_m, spacing_m, at.x, at.y};
  block.size = {side, baked.heights().levels() - 1, terrain.tiling, 0};
  const double edge_m = spacing_m * (side - 1);
  block.box = {corner_m.x, corner_m.y, corner_m.x + edge_m, corner_m.y + edge_m};
  // A map that stands alone has the plain about it, which no height below 0 may hide.
  const double low_m = terrain.tiling ? baked.lowest_m() : std::min(0.0F, baked.lowest_m());
  block.altitude = {terrain.base_m, terrain.base_m + baked.highest_m(), terrain.base_m + low_m, width.y};
  block.cover = {terrain.snow_line_m, terrain.tree_line_m, std::tan(terrain.rock_slope_deg * radians_per_degree), 0};
  // tuned: twice the sun's radius hides that shadows are interpolated between lattice points.
  block.sun = {towards_sun.x, towards_sun.y, 2 * sun.angular_radius_deg * radians_per_degree, width.x};
  const std::optional<double>& water_m = request.cloudscape->ground.water.level_m;
  block.rock = xyz_w(terrain.rock_albedo, water_m ? *water_m - terrain.base_m : -1e9);
  block.snow = xyz_w(terrain.snow_albedo, 0);
  return block;
}

}  // namespace cloudscape::render
