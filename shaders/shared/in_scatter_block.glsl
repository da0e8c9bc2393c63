// The grid of the in-scatter volume that extinction is sampled for (server/render fills it). Binding 0, in place of the bake blocks.
#ifndef SHARED_IN_SCATTER_BLOCK
#define SHARED_IN_SCATTER_BLOCK
#include "shared/block.glsl"

/* first: of the grid's points, relative to the camera's point at sea level (m). spacing: of the points (m). size: of the grid. */
#define IN_SCATTER_FIELDS(F) \
  F(vec4, first) \
  F(vec4, spacing) \
  F(ivec4, size)
DECLARE_BLOCK(InScatterBlock, in_scatter_grid, 0, IN_SCATTER_FIELDS)
#endif
