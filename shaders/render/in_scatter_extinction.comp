// Extinction at the points of the in-scatter volume, 1/m: the mean of 27 points of the medium about each.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "shared/in_scatter_block.glsl"
#include "render/density_in_box.glsl"
layout(binding = 0, r32f) uniform writeonly image3D target;

// Into the tile, where it repeats.
vec3 around_tile(vec3 p) {
  vec3 size = cloud.box_high.xyz - cloud.box_low.xyz;
  if (cloud.box_low.w > 0.0) p.xy = cloud.box_low.xy + size.xy * fract((p.xy - cloud.box_low.xy) / size.xy);
  return p;
}

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  if (texel.z >= volume_pass.z_end || any(greaterThanEqual(texel.xy, in_scatter_grid.size.xy))) return;
  vec3 middle = in_scatter_grid.first.xyz + in_scatter_grid.spacing.xyz * vec3(texel);
  float sum = 0.0;
  for (int i = 0; i < 27; ++i) {
    vec3 part = vec3(i % 3, (i / 3) % 3, i / 9) - 1.0;
    sum += density_in_box(around_tile(middle + in_scatter_grid.spacing.xyz * part / 3.0));
  }
  imageStore(target, texel, vec4(cloud.medium.x * sum / 27.0));
}
