// Bakes the shape of one layer of several, in its own slices: its noises mixed by their weights, and formed by its heights and towers
// between its bottom and its top.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "bake/shape_noise.glsl"
layout(binding = 0, r16f) uniform writeonly image3D target;

// What a finer channel adds to the factor on the shape; a loop, so that one without weight is left out.
float finer(vec3 position, ivec4 lattice, vec4 blend, uint salt) {
  float sum = 0.0;
  int count = blend.z > 0.0 ? 1 : 0;
  for (int i = 0; i < count; ++i) sum += blend.z * (channel(position, lattice, blend, salt) - 0.5);
  return sum;
}

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  vec3 position = (vec3(texel + ivec3(0, 0, bake.slices.x)) + 0.5) / vec3(bake.size.xyz);
  float height = (position.z - bake.layer.x) / (bake.layer.y - bake.layer.x);
  float shape = channel(position, bake.channel_0, bake.mix_0, 0u);
  shape = shape * height_distribution(height, bake.profile.x, bake.profile.y) + towers_offset(vec3(position.xy, height), shape);
  float factor = 1.0 + finer(position, bake.channel_1, bake.mix_1, 1u) + finer(position, bake.channel_2, bake.mix_2, 2u) +
                 finer(position, bake.channel_3, bake.mix_3, 3u);
  imageStore(target, texel, vec4(clamp(shape, 0.0, 1.0) * factor));
}
