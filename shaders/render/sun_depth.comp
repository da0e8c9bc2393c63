// Metres of full density between points of the clouds' tile and the light. The points lie in the middle of the cells across, and from
// the lowest cloud (the first layer) to the highest (the last); levels of the threshold one above the other.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "shared/sun_block.glsl"
#include "render/sun_path.glsl"
layout(binding = 0) uniform sampler3D sun_density;
layout(binding = 0, r32f) uniform writeonly image3D target;

const float most_steps = 48.0;  // tuned: a low sun's way is sampled coarser, so that no slice takes longer than another

float density_in_level(vec3 place, float level) {
  float layers = float(sun_grid.size.z);
  float up = (place.z - sun_grid.levels.z) / (sun_grid.levels.w - sun_grid.levels.z) * layers;
  float row = level * layers + clamp(up, 0.5, layers - 0.5);
  return textureLod(sun_density, vec3(place.xy, row / (layers * float(sun_grid.size.w))), 0.0).x;
}

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  if (any(greaterThanEqual(texel.xy, sun_grid.size.xy)) || texel.z >= volume_pass.z_end) return;
  int level = texel.z / sun_grid.size.z;
  float up = float(texel.z - level * sun_grid.size.z) / float(sun_grid.size.z - 1);
  float low = sun_grid.levels.z, high = sun_grid.levels.w;
  vec3 light = sun_grid.light.xyz;
  vec3 place = vec3((vec2(texel.xy) + 0.5) / vec2(sun_grid.size.xy), mix(low, high, up));
  float end_m = distance_to_rise((high - place.z) / cloud.layer.z, light.z);
  end_m = min(end_m, within_tile(place, light).y);
  vec3 cells = (place_towards(place, light, end_m) - place) * vec3(sun_grid.size.xy, float(sun_grid.size.z) / (high - low));
  float steps = clamp(ceil(max(length(cells.xy), cells.z)), 1.0, most_steps);
  float sum = 0.0;
  for (float i = 0.5; i < steps; ++i) sum += density_in_level(place_towards(place, light, end_m * i / steps), float(level));
  imageStore(target, texel, vec4(sum * end_m / steps));
}
