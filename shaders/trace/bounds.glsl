// The greatest density ahead of a ray: what delta tracking (Woodcock et al. 1965) and ratio tracking (Novak et al. 2014) draw
// their distances from.
#ifndef TRACE_BOUNDS
#define TRACE_BOUNDS
#include "shared/trace_block.glsl"
#include "render/medium.glsl"
layout(binding = 6) uniform sampler3D majorants;          // server/bake/majorants.h
layout(binding = 15) uniform sampler3D coarse_majorants;

// No density along the next `free_m` of a ray is greater.
struct Bound {
  float density;
  float free_m;
};

// Where the ray can meet the medium. What goes through the planet does not come up again, even where there is no ground; and a
// tile that stands alone ends at its sides.
Stretch traced_stretch(vec3 origin, vec3 direction) {
  Stretch found = medium_stretch(origin, direction);
  if (volume_kind() != volume_noise) return found;  // flat
  vec2 planet = intersect_altitude(origin, direction, 0.0);
  if (planet.x <= planet.y && planet.x > 0.0) found.end = min(found.end, planet.x);
  if (cloud.box_low.w != 0.0) return found;
  vec2 sides = intersect_box(origin, direction, vec3(cloud.box_low.xy, -no_hit_m), vec3(cloud.box_high.xy, no_hit_m));
  found.begin = max(found.begin, sides.x);
  found.end = min(found.end, sides.y);
  return found;
}

// A point among cells of the layer, and how fast it moves, both in cells; `slack`: how much faster it can.
struct CellWalk {
  vec3 at, speed, slack;
};

// How far the ray goes until it can be more than `reach` beyond the faces of its cell, m.
float distance_in_cell(CellWalk walk, vec3 cell, float reach) {
  vec3 speed = abs(walk.speed) + walk.slack;
  vec3 room = mix(walk.at - cell, cell + 1.0 - walk.at, step(vec3(0.0), walk.speed));
  vec3 time = (min(room, 1.0) + reach) / max(speed, vec3(1.0e-12));
  // The slack of altitudes holds for two kilometres; and rounding must not stop a ray.
  return clamp(min(time.x, min(time.y, time.z)), 0.01, 2000.0);
}

vec3 cell_of(vec3 at, float layers) { return vec3(floor(at.xy), clamp(floor(at.z), 0.0, layers - 1.0)); }

float density_below(float greatest_shape, float threshold) {
  return clamp((greatest_shape - threshold) / cloud.shape.y, 0.0, 1.0);
}

// Of a noise layer or a grid: from the coarse cell if it is empty, else from the fine one.
Bound layer_bound(vec3 p, vec3 direction) {
  const float reach = 0.5;  // server/bake/majorants.h
  Land land = land_at(p);
  vec3 cells = vec3(trace.cells.xyz);
  // Altitude changes with the slope of the ray against the curved planet, and that changes on the way.
  float climb = direction.z + cloud.volume.y * dot(p.xy, direction.xy) / (planet_radius_m + p.z);
  CellWalk walk;
  vec2 across = direction.xy - cloud.lean.xy * climb * cloud.layer.z;
  walk.at = vec3(tile_at(p) + land.shift, height_in_layer(p)) * cells;
  walk.speed = vec3(across * cloud.tile.xy, climb * cloud.layer.z) * cells;
  vec2 bend = abs(cloud.lean.xy) * cloud.tile.xy * trace.slopes.w;
  walk.slack = vec3(trace.slopes.xy + bend, trace.slopes.w) * cells;
  float block = float(trace.cells.w);
  vec3 blocks = vec3(textureSize(coarse_majorants, 0));
  CellWalk wide = CellWalk(walk.at / block, walk.speed / block, walk.slack / block);
  vec3 cell = cell_of(wide.at, blocks.z);
  float free_m = distance_in_cell(wide, cell, reach / block);
  float shape = textureLod(coarse_majorants, (cell + 0.5) * block / vec3(cells.xy, block * blocks.z), 0.0).x;
  if (shape <= land.threshold - trace.slopes.z * free_m) return Bound(0.0, free_m);
  cell = cell_of(walk.at, cells.z);
  free_m = distance_in_cell(walk, cell, reach);
  vec2 most = textureLod(majorants, (cell + 0.5) / cells, 0.0).xy;
  return Bound(most.y * density_below(most.x, land.threshold - trace.slopes.z * free_m), free_m);
}

// Of a Gaussian: as dense as at the nearest that a standard deviation's way can bring it to the middle.
Bound gaussian_bound(vec3 p) {
  float deviation_m = 0.125 * (cloud.box_high.x - cloud.box_low.x);
  float nearest = max(0.0, length(p - box_center()) / deviation_m - 1.0);
  return Bound(exp(-0.5 * nearest * nearest), deviation_m);
}

Bound density_bound(vec3 p, vec3 direction) {
  if (is_textured()) return layer_bound(p, direction);
  if (volume_kind() == volume_gaussian) return gaussian_bound(p);
  return Bound(1.0, no_hit_m);
}
#endif
