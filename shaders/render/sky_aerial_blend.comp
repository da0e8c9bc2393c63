// The aerial perspective of a camera between two levels, from the tables of both.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(binding = 0, rgba32f) uniform writeonly image3D target;
#include "shared/sky_block.glsl"
layout(binding = 0) uniform sampler3D lower;
layout(binding = 1) uniform sampler3D upper;

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  if (any(greaterThanEqual(texel, textureSize(lower, 0)))) return;
  imageStore(target, texel, mix(texelFetch(lower, texel, 0), texelFetch(upper, texel, 0), sky.level.y));
}
