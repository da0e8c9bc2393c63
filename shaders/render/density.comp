// Writes the density of the medium, with all its detail, into voxels: of each the mean of eight points.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "shared/density_block.glsl"
#include "render/medium.glsl"
layout(binding = 0, r32f) uniform writeonly image3D target;

float density_in_box(vec3 p) {
  if (any(lessThan(p, cloud.box_low.xyz)) || any(greaterThan(p, cloud.box_high.xyz))) return 0.0;
  if (volume_kind() == volume_sphere && distance(p, box_center()) > sphere_radius_m()) return 0.0;
  return density_at(p);
}

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  ivec3 voxel = texel + ivec3(0, 0, density_values.size.w);
  if (any(greaterThanEqual(voxel, density_values.size.xyz))) return;
  float sum = 0.0;
  for (int i = 0; i < 8; ++i) {
    vec3 part = 0.25 + 0.5 * vec3(i & 1, (i >> 1) & 1, i >> 2);
    sum += density_in_box(density_values.corner.xyz + density_values.corner.w * (vec3(voxel) + part));
  }
  imageStore(target, texel, vec4(sum / 8.0));
}
