// The volume of the light's way through the clouds (server/render fills it). Binding 0, in place of the bake blocks.
#ifndef SHARED_SUN_BLOCK
#define SHARED_SUN_BLOCK
#include "shared/block.glsl"

/* light: towards it, 0. levels: threshold of the lowest level, from one to the next, heights (0..1 of the layer) between which there is
   cloud. size: cells east, north and up of a level, levels, one above the other. */
#define SUN_FIELDS(F) \
  F(vec4, light) \
  F(vec4, levels) \
  F(ivec4, size)
DECLARE_BLOCK(SunBlock, sun_grid, 0, SUN_FIELDS)
#endif
