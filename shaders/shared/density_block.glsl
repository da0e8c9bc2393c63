// The voxels that density is written into (server/render fills it). Binding 0, in place of the bake blocks.
#ifndef SHARED_DENSITY_BLOCK
#define SHARED_DENSITY_BLOCK
#include "shared/block.glsl"

/* corner: of the first voxel, relative to the camera's point at sea level (m); length of a voxel's edge (m).
   size: voxels east, north and up; slice that the target begins with. */
#define DENSITY_FIELDS(F) \
  F(vec4, corner) \
  F(ivec4, size)
DECLARE_BLOCK(DensityBlock, density_values, 0, DENSITY_FIELDS)
#endif
