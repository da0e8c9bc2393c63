// How fast the shape noise changes, at most, in each cube of eight texel middles: from the texel to the next east, north and up (1/m).
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "shared/distance_block.glsl"
#include "lib/around_edges.glsl"
layout(binding = 0, r32f) uniform writeonly image3D target;
layout(binding = 0) uniform sampler3D shape_texture;

// Shape (x) and what the finer channels make of it (y).
vec2 corner(ivec3 at, ivec3 size) {
  vec4 noise = texelFetch(shape_texture, around_edges(at, size), 0);
  return vec2(noise.x, max(1.0 + dot(distance_values.weights.yzw, noise.yzw - 0.5), 0.0));
}

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  ivec3 size = textureSize(shape_texture, 0);
  if (any(greaterThanEqual(texel, size))) return;
  vec2 corners[8];
  vec2 greatest = vec2(0.0);
  for (int i = 0; i < 8; ++i) {
    corners[i] = corner(texel + ivec3(i & 1, (i >> 1) & 1, i >> 2), size);
    greatest = max(greatest, corners[i]);
  }
  // The channels are interpolated one by one, and then multiplied: the product rule.
  vec3 slope = vec3(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    int bit = 1 << axis;
    vec2 change = vec2(0.0);
    for (int i = 0; i < 8; ++i) change = max(change, abs(corners[i | bit] - corners[i & ~bit]));
    slope[axis] = dot(change, greatest.yx) * float(size[axis]) / distance_values.tile_m[axis];
  }
  imageStore(target, texel, vec4(length(slope)));
}
