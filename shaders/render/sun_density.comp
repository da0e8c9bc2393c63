// Mean density in the cells of the clouds' tile, for the light's way through them: of 8 points of the shape in each, half of them
// eroded less and half more than on average. Levels of the threshold stand one above the other. The cloud block is that of an upright, flat tile with no slow change.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "shared/sun_block.glsl"
#include "render/medium.glsl"

const float erosion_spread = 0.25;  // tuned against a fine march of all the detail, which erodes unevenly
layout(binding = 0, r32f) uniform writeonly image3D target;

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  if (any(greaterThanEqual(texel.xy, sun_grid.size.xy)) || texel.z >= volume_pass.z_end) return;
  int level = texel.z / sun_grid.size.z;
  vec3 cell = vec3(texel.xy, texel.z - level * sun_grid.size.z);
  Land land = Land(sun_grid.levels.x + float(level) * sun_grid.levels.y, vec2(0.0));
  float sum = 0.0;
  for (int i = 0; i < 8; ++i) {
    vec3 place = (cell + 0.25 + 0.5 * vec3(i & 1, (i >> 1) & 1, i >> 2)) / vec3(sun_grid.size.xyz);
    float height = mix(sun_grid.levels.z, sun_grid.levels.w, place.z);
    vec3 p = vec3(place.xy / cloud.tile.xy, cloud.layer.x + height / cloud.layer.z);
    float erosion = mean_erosion + ((i ^ (i >> 1) ^ (i >> 2)) % 2 == 0 ? erosion_spread : -erosion_spread);
    sum += density_of(shape_above_threshold(p, land), erosion, 0.0);
  }
  imageStore(target, texel, vec4(sum / 8.0));
}
