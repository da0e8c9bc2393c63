// What the shaders that build the structure need (server/bake fills it). Binding 0.
#ifndef SHARED_STRUCTURE_BLOCK
#define SHARED_STRUCTURE_BLOCK
#include "shared/block.glsl"

/* weights: 1 and those of the shape texture's finer channels. size: cells east, north and up; texels a side of the shape texture.
   reach: how far beyond each cell's faces the noise is looked for, cells; whether green is the layers' density, or the
   least noise; 0. */
#define STRUCTURE_FIELDS(F) \
  F(vec4, weights) \
  F(ivec4, size) \
  F(vec4, reach)
DECLARE_BLOCK(StructureBlock, structure_values, 0, STRUCTURE_FIELDS)
#endif
