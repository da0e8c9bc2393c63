// Bakes the shape texture as four noises, which the march mixes.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "bake/shape_noise.glsl"
layout(binding = 0, rgba8) uniform writeonly image3D target;

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  imageStore(target, texel, shape_noise(texel));
}
