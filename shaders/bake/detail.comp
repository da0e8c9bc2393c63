// Bakes the detail texture: Worley fBm in red (billows) and Perlin fBm in green (wisps), tiling.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "bake/permutation.glsl"
#include "shared/bake_block.glsl"
#include "lib/perlin.glsl"
#include "lib/shape.glsl"
#include "lib/worley.glsl"
layout(binding = 0, rgba8) uniform writeonly image3D target;

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  vec3 position = (vec3(texel) + 0.5) / float(bake.detail.z);
  float billows = worley_fbm(position, ivec3(bake.detail.x), bake.detail.y, 2, 0.5, bake.seed.x * 16u + 9u);
  float wisps = perlin_fbm(position, ivec3(bake.detail.x), bake.detail.y, 2, 0.5);
  imageStore(target, texel, vec4(stretch(billows, 0.3, 0.95), stretch(wisps, 0.25, 0.75), 0.0, 1.0));
}
