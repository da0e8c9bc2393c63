// What the bake shaders need (server/bake fills it). Binding 0.
#ifndef SHARED_BAKE_BLOCK
#define SHARED_BAKE_BLOCK
#include "shared/block.glsl"

/* channel_n: cells east and north, octaves, lacunarity, cells up; mix_n: Worley mix, gain, weight, 0 of the four shape channels.
   profile: height_rise, height_fall, number of towers, 0. seed: seed, permutation seed != 0, 0, 0.
   detail: frequency, octaves, resolution, 0. Of several layers the one at work, layer: bottom, top (heights in the volume, 0..1), threshold,
   density; slices: its lowest, how many of them, the first whose columns are looked through, whether there is no layer yet. */
#define BAKE_FIELDS(F) \
  F(ivec4, channel_0) \
  F(ivec4, channel_1) \
  F(ivec4, channel_2) \
  F(ivec4, channel_3) \
  F(vec4, mix_0) \
  F(vec4, mix_1) \
  F(vec4, mix_2) \
  F(vec4, mix_3) \
  F(vec4, profile) \
  F(uvec4, seed) \
  F(ivec4, size) \
  F(ivec4, detail) \
  F(vec4, layer) \
  F(ivec4, slices)
DECLARE_BLOCK(BakeBlock, bake, 0, BAKE_FIELDS)
#endif
