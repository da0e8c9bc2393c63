// The height lattice of a terrain and how a line crosses it (server/bake: TerrainTexels).
#ifndef RENDER_TERRAIN_LATTICE
#define RENDER_TERRAIN_LATTICE
#include "shared/terrain_block.glsl"
#include "lib/relief.glsl"
layout(binding = 11) uniform sampler2D terrain_heights;

// Height of a point of a level, and the greatest height in the cell north-east of it, m above the base.
vec2 lattice_point(ivec2 point, int level) {
  return texelFetch(terrain_heights, point & ivec2((terrain.size.x >> level) - 1), level).xy;
}

// The surface of one cell: height at its corners.
vec4 cell_corners(ivec2 cell, int level) {
  return vec4(lattice_point(cell, level).x, lattice_point(cell + ivec2(1, 0), level).x, lattice_point(cell + ivec2(0, 1), level).x,
              lattice_point(cell + ivec2(1, 1), level).x);
}
float height_in_cell(vec4 corners, vec2 at) {
  return mix(mix(corners.x, corners.y, at.x), mix(corners.z, corners.w, at.x), at.y);
}

// A level line through the lattice: points a metre, none of them 0.
vec2 lattice_direction(vec2 direction) {
  vec2 d = direction * terrain.lattice.x;
  return vec2(abs(d.x) < 1.0e-9 ? 1.0e-9 : d.x, abs(d.y) < 1.0e-9 ? 1.0e-9 : d.y);
}

// How far it is from `at`, which lies in the cell, to where the line leaves it, m.
float distance_to_exit(vec2 at, vec2 cell, float cell_points, vec2 direction) {
  vec2 edge = (cell + step(vec2(0.0), direction)) * cell_points;
  vec2 to_edge = (edge - at) / direction;
  return max(0.0, min(to_edge.x, to_edge.y));
}
#endif
