// What the shader that makes a terrain needs (server/bake fills it). Binding 0, in place of the clouds' bake block.
#ifndef SHARED_TERRAIN_BAKE_BLOCK
#define SHARED_TERRAIN_BAKE_BLOCK
#include "shared/block.glsl"

/* noise: mountains a side, octaves, resolution, 0. shape: roughness, erosion, 0, 0. seed: seed, 0, 0, 0. */
#define TERRAIN_BAKE_FIELDS(F) \
  F(ivec4, noise) \
  F(vec4, shape) \
  F(uvec4, seed)
DECLARE_BLOCK(TerrainBakeBlock, terrain_bake, 0, TERRAIN_BAKE_FIELDS)
#endif
