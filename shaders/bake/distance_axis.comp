// One axis of the separable distance transform (Felzenszwalb and Huttenlocher 2012, of boxes instead of points): the least over the cells along
// it of the square of the gap to them and what the axes before found there. Above 0 to cloud, below 0 to clear air, of which what is on the
// other side, or on neither, is the nearest. East and north go on around the tile's edges.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "shared/distance_block.glsl"
#include "lib/around_edges.glsl"
layout(binding = 0, rgba32f) uniform writeonly image3D target;
layout(binding = 0) uniform sampler3D squares;

vec4 square_at(ivec3 cell) {
  ivec3 size = distance_values.cells.xyz;
  bool within = cell.z >= 0 && cell.z < size.z;
  cell.z = clamp(cell.z, 0, size.z - 1);  // seen already, and nearer; but above and below the tile all is clear
  vec4 square = texelFetch(squares, around_edges(cell, size), 0);
  return within ? square : max(square, vec4(0.0));
}

void main() {
  ivec3 cell = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  if (any(greaterThanEqual(cell, distance_values.cells.xyz))) return;
  vec4 found = texelFetch(squares, cell, 0);
  vec4 side = sign(found), least = abs(found);
  for (int k = 1; k <= distance_values.step.w; ++k) {
    float gap_m = float(k - 1) * distance_values.lengths.x;
    float square = gap_m * gap_m;
    if (square >= max(max(least.x, least.y), max(least.z, least.w))) break;
    ivec3 away = k * distance_values.step.xyz;
    least = min(least, square + max(min(side * square_at(cell + away), side * square_at(cell - away)), 0.0));
  }
  imageStore(target, cell, side * least);
}
