// What the shaders that build the distance field need (server/bake fills it). Binding 0.
#ifndef SHARED_DISTANCE_BLOCK
#define SHARED_DISTANCE_BLOCK
#include "shared/block.glsl"

/* cells: east, north and up; levels. thresholds: of the lowest of the four levels that are at work; between levels; 0, 0.
   step: along the axis at work, cells; how far it is searched, cells. lengths: of a cell along that axis, the greatest distance that is told
   (m); fall of the threshold on the way (1/m); 0. weights: 1 and those of the shape texture's finer channels. tile_m: east, north and up (m);
   whether the shape changes without jumps. */
#define DISTANCE_FIELDS(F) \
  F(ivec4, cells) \
  F(vec4, thresholds) \
  F(ivec4, step) \
  F(vec4, lengths) \
  F(vec4, weights) \
  F(vec4, tile_m)
DECLARE_BLOCK(DistanceBlock, distance_values, 0, DISTANCE_FIELDS)
#endif
