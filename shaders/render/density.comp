// Writes the density of the medium, with all its detail, into voxels: of each the mean of eight points.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "shared/density_block.glsl"
#include "render/density_in_box.glsl"
#include "render/structure.glsl"
layout(binding = 0, r32f) uniform writeonly image3D target;

// Whether there can be density in a voxel: outside the structure none is within half a large step.
bool can_be_dense(vec3 middle) {
  bool small = 0.87 * density_values.corner.w < 0.5 * cloud.structure.x;  // half a cube's diagonal
  return !is_textured() || !small || place_in_structure(middle, land_at(middle)) != outside_structure;
}

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  ivec3 voxel = texel + ivec3(0, 0, density_values.size.w);
  if (any(greaterThanEqual(voxel, density_values.size.xyz))) return;
  vec3 corner = density_values.corner.xyz + density_values.corner.w * vec3(voxel);
  int points = can_be_dense(corner + 0.5 * density_values.corner.w) ? 8 : 0;
  float sum = 0.0;
  for (int i = 0; i < points; ++i) {
    vec3 part = 0.25 + 0.5 * vec3(i & 1, (i >> 1) & 1, i >> 2);
    sum += density_in_box(corner + density_values.corner.w * part);
  }
  imageStore(target, texel, vec4(sum / 8.0));
}
