// Begins the distance transform of four thresholds (server/bake/distance_field.h): the square of the greatest distance that is told in each
// cell without cloud, minus that in each that is all cloud, 0 in the others.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "shared/distance_block.glsl"
layout(binding = 0, rgba32f) uniform writeonly image3D target;
layout(binding = 0) uniform sampler3D shape_range;  // greatest and least

void main() {
  ivec3 cell = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  if (any(greaterThanEqual(cell, distance_values.cells.xyz))) return;
  vec4 thresholds = distance_values.thresholds.x + distance_values.thresholds.y * vec4(0.0, 1.0, 2.0, 3.0);
  vec2 range = texelFetch(shape_range, cell, 0).xy;
  vec4 clear = vec4(lessThanEqual(vec4(range.x), thresholds)), cloud = vec4(greaterThan(vec4(range.y), thresholds));
  float farthest_m = distance_values.lengths.y;
  imageStore(target, cell, farthest_m * farthest_m * (clear - cloud));
}
