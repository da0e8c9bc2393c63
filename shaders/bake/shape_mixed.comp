// Bakes the shape texture as one number: the four noises mixed by their weights, as the march mixes those of eight bits.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "bake/shape_noise.glsl"
layout(binding = 0, r16f) uniform writeonly image3D target;

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  vec4 noise = clamp(shape_noise(texel), 0.0, 1.0);
  vec3 weights = vec3(bake.mix_1.z, bake.mix_2.z, bake.mix_3.z);
  imageStore(target, texel, vec4(mixed_shape(noise.x, vec3(noise.yzw), weights)));
}
