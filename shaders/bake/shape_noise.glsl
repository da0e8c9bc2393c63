// The noises of the shape texture at a position in the tile: four channels of Perlin-Worley fBm; x is the cloud shape, with height
// distribution and towers (Olajos 2.2, 2.3), y, z and w are finer noise to mix in. All tile in the three directions.
#ifndef BAKE_SHAPE_NOISE
#define BAKE_SHAPE_NOISE
#include "bake/permutation.glsl"
#include "shared/bake_block.glsl"
#include "lib/perlin.glsl"
#include "lib/shape.glsl"
#include "lib/worley.glsl"
layout(binding = 1) uniform sampler2D towers;  // two texels a tower: center east, north, radius, top; strength, 0, 0, 0

float channel(vec3 position, ivec4 lattice, vec4 blend, uint salt) {
  float worley = 0.0;
  float perlin = 0.0;
  ivec3 cells = ivec3(lattice.x, lattice.x, lattice.w);
  if (blend.x > 0.0) worley = worley_fbm(position, cells, lattice.y, lattice.z, blend.y, bake.seed.x * 16u + salt);
  if (blend.x < 1.0) perlin = perlin_fbm(position, cells, lattice.y, lattice.z, blend.y);
  // tuned: the span that fBm of either kind really takes, spread over 0..1 so that eight bits and the height distribution
  // have contrast to work with.
  return mix(stretch(perlin, 0.25, 0.75), stretch(worley, 0.3, 0.95), blend.x);
}

// `shape`: the noise at the position, 0..1. tuned: it pushes a tower's surface up by a third and down by a half, so that turrets
// bulge as the clouds around them do; a plain bell looks like a mountain.
float towers_offset(vec3 position, float shape) {
  float offset = 0.0;
  float height = position.z / mix(0.45, 1.3, shape);
  for (int i = 0; i < int(bake.profile.z); ++i) {
    vec4 bell = texelFetch(towers, ivec2(2 * i, 0), 0);
    float strength = texelFetch(towers, ivec2(2 * i + 1, 0), 0).x;
    offset += tower_offset(position.xy, height, bell.xy, bell.z, bell.w, strength);
  }
  return offset * mix(0.35, 1.0, shape);
}

vec4 shape_noise(ivec3 texel) {
  vec3 position = (vec3(texel) + 0.5) / vec3(bake.size.xyz);
  float shape = channel(position, bake.channel_0, bake.mix_0, 0u);
  shape = shape * height_distribution(position.z, bake.profile.x, bake.profile.y) + towers_offset(position, shape);
  return vec4(shape, channel(position, bake.channel_1, bake.mix_1, 1u), channel(position, bake.channel_2, bake.mix_2, 2u),
              channel(position, bake.channel_3, bake.mix_3, 3u));
}
#endif
