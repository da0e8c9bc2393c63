// Bakes the variation map, one layer of a 3D texture: slow Perlin fBm, red for coverage, green and blue to shift the tile.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "bake/permutation.glsl"
#include "shared/bake_block.glsl"
#include "lib/perlin.glsl"
#include "lib/shape.glsl"
layout(binding = 0, rgba16f) uniform writeonly image3D target;

// Four lattice cells a period (core: wavelength_m is a quarter of the map's period), three octaves.
float slow_noise(vec2 position, float slice) {
  return stretch(perlin_fbm(vec3(position, slice), ivec3(4), 3, 2, 0.5), 0.3, 0.7);
}

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  if (texel.z > 0) return;
  vec2 position = (vec2(texel.xy) + 0.5) / 128.0;
  imageStore(target, texel, vec4(slow_noise(position, 0.1), slow_noise(position, 0.4), slow_noise(position, 0.7), 1.0));
}
