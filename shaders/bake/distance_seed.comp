// Begins the distance transform of four thresholds (server/bake/distance_field.h): 0 in each cell that can hold cloud, elsewhere the square
// of the greatest distance that is told.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "shared/distance_block.glsl"
layout(binding = 0, rgba32f) uniform writeonly image3D target;
layout(binding = 0) uniform sampler3D greatest_shape;

void main() {
  ivec3 cell = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  if (any(greaterThanEqual(cell, distance_values.cells.xyz))) return;
  vec4 thresholds = distance_values.thresholds.x + distance_values.thresholds.y * vec4(0.0, 1.0, 2.0, 3.0);
  bvec4 cloud = greaterThan(vec4(texelFetch(greatest_shape, cell, 0).x), thresholds);
  float farthest_m = distance_values.lengths.y;
  imageStore(target, cell, mix(vec4(farthest_m * farthest_m), vec4(0.0), cloud));
}
