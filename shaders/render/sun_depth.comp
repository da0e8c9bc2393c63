// Metres of full density between points of the clouds' tile and the light.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "render/cloud_grid.glsl"
layout(binding = 0, r32f) uniform writeonly image3D target;

const float most_steps = 48.0;  // tuned: a low sun's way is sampled coarser, so that no slice takes longer than another

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  if (!is_in_grid(texel, imageSize(target))) return;
  GridPoint point = grid_point(texel, imageSize(target));
  vec3 light = sun_grid.light.xyz;
  float end_m = distance_to_rise((sun_grid.levels.w - point.place.z) / cloud.layer.z, light.z);
  end_m = min(end_m, within_tile(point.place, light).y);
  float steps = clamp(ceil(cells_between(point.place, place_towards(point.place, light, end_m))), 1.0, most_steps);
  float sum = 0.0;
  for (float i = 0.5; i < steps; ++i) sum += grid_density(place_towards(point.place, light, end_m * i / steps), point.level);
  imageStore(target, texel, vec4(sum * end_m / steps));
}
