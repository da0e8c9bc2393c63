// Where a point lies about the clouds by their preprocessed structure (server/bake/structure.h).
#ifndef RENDER_STRUCTURE
#define RENDER_STRUCTURE
#include "render/medium.glsl"
layout(binding = 4) uniform sampler3D structure_texture;

// How far outside the structure a point is (Olajos 2.4.2): outside all of its padding, which is wider than half a large step, so that no
// cloud stands between two such points that are a large step apart; within the outer layer of it only; or near cloud.
const int near_cloud = 0;
const int in_outer_padding = 1;
const int outside_structure = 2;

int place_in_structure(vec3 p, Land land) {
  vec2 tile = tile_at(p);
  vec2 bound = textureLod(structure_texture, vec3(tile + land.shift, clamp(height_in_layer(p), 0.0, 1.0)), 0.0).xy;
  float lowest = land.threshold - cloud.structure.y;
  return bound.x <= lowest ? outside_structure : bound.y <= lowest ? in_outer_padding : near_cloud;
}
#endif
