// Where a view ray meets the terrain: from cell to cell of the lattice, over the cells whose highest point lies below the ray;
// in the others the ray and the bilinear surface meet where a parabola is zero, so that no ridge is missed and none has steps.
#ifndef RENDER_TERRAIN_HIT
#define RENDER_TERRAIN_HIT
#include "render/terrain_lattice.glsl"
#include "lib/intersect.glsl"

const int most_terrain_cells = 320;

// Width of a pixel at a distance, m.
float pixel_width_m(float distance_m) { return terrain.sun.w + terrain.altitude.w * distance_m; }

// The stretch of the ray on which it can meet the terrain.
vec2 terrain_stretch(vec3 origin, vec3 direction) {
  vec2 shell = intersect_altitude(origin, direction, terrain.altitude.y + 0.01);
  if (shell.x > shell.y || shell.y <= 0.0) return vec2(1.0, -1.0);
  vec2 stretch = vec2(max(shell.x, 0.0), shell.y);
  vec2 lowest = intersect_altitude(origin, direction, terrain.altitude.z - 0.01);
  if (lowest.x <= lowest.y && lowest.x > 0.0) stretch.y = min(stretch.y, lowest.x);
  if (terrain.size.z == 1) return stretch;
  vec2 box = intersect_box(origin, direction, vec3(terrain.box.xy, -no_hit_m), vec3(terrain.box.zw, no_hit_m));
  return vec2(max(stretch.x, box.x), min(stretch.y, box.y));
}

// Height of the ray above the surface of a cell where it enters, in the middle, and where it leaves.
vec3 clearance_m(vec3 altitudes_m, vec4 corners, vec2 enter, vec2 leave) {
  return altitudes_m - vec3(height_in_cell(corners, enter), height_in_cell(corners, 0.5 * (enter + leave)),
                            height_in_cell(corners, leave));
}

// Distance to the terrain, m; no_hit_m where there is none. Land is seen from above only: a camera below the surface looks through
// it up to where its ray comes out.
float terrain_distance_m(vec3 origin, vec3 direction) {
  vec2 stretch = terrain_stretch(origin, direction);
  vec2 lattice = lattice_direction(direction.xy);
  vec2 begin = terrain.lattice.zw + origin.xy * terrain.lattice.x;
  float sag = dot(direction.xy, direction.xy) / (8.0 * planet_radius_m);
  float nudge = 1.0e-3 * terrain.lattice.y;
  float t = stretch.x;
  float altitude_m = altitude_of(origin + direction * t) - terrain.altitude.x;
  bool below = false;
  bool first = true;
  int level = min(4, terrain.size.y);
  for (int i = 0; i < most_terrain_cells && t < stretch.y; ++i) {
    float cell_points = float(1 << level);
    vec2 at = begin + lattice * t;
    vec2 cell = floor(at / cell_points);
    float leave = min(t + distance_to_exit(at, cell, cell_points, lattice), stretch.y);
    float length_m = leave - t;
    float leave_altitude_m = altitude_of(origin + direction * leave) - terrain.altitude.x;
    float bend_m = sag * length_m * length_m;  // the ray's middle lies so far below the mean of its ends
    bool above_all = min(altitude_m, leave_altitude_m) - bend_m > lattice_point(ivec2(cell), level).y;
    if (above_all) {
      level = min(level + 1, terrain.size.y);
    } else if (level > 0 && cell_points * terrain.lattice.y > pixel_width_m(t)) {
      --level;
      continue;
    } else {
      vec3 altitudes_m = vec3(altitude_m, 0.5 * (altitude_m + leave_altitude_m) - bend_m, leave_altitude_m);
      vec2 enter = clamp(at / cell_points - cell, 0.0, 1.0);
      vec2 end = clamp((begin + lattice * leave) / cell_points - cell, 0.0, 1.0);
      vec3 clear_m = clearance_m(altitudes_m, cell_corners(ivec2(cell), level), enter, end);
      if (first) below = clear_m.x < 0.0;
      if (!below && clear_m.x <= 0.0) return t;  // between two levels
      if (!below) {
        float root = first_root(clear_m.x, clear_m.y, clear_m.z);
        if (root <= 1.0) return t + root * length_m;
      }
      below = below && clear_m.z < 0.0;
    }
    first = false;
    t = leave + nudge + 1.0e-6 * leave;
    altitude_m = leave_altitude_m;
  }
  return t < stretch.y && !below ? t : no_hit_m;  // so many cells only where the ray grazes the land
}
#endif
