// What the march looks up: for each level of the threshold, one above the other, how far a point of a cell is from cloud, or (below 0) within cloud
// from clear air, wherever the land may change the threshold on the way (m); how far the noise takes to change by 1, in the cell and those about it (m).
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "shared/distance_block.glsl"
layout(binding = 0, rg16f) uniform writeonly image3D target;
layout(binding = 0) uniform sampler3D squares;  // of a level in each channel
layout(binding = 1) uniform sampler3D padded_slopes;

// Above 0 to cloud, below 0 to clear air; 0: neither is far, or there is no such level.
float distance_m(ivec3 cell, int level) {
  float square = level < 4 ? texelFetch(squares, cell, 0)[level] : 0.0;
  return sign(square) * sqrt(abs(square));
}

// How far, on one side (1: no cloud, -1: nothing but cloud), from a level on. Within the first `spacing / |change|` metres the threshold can
// come down to the next lower level, or up to the next higher one, and so on.
float reach_m(ivec3 cell, int level, int side) {
  float change = distance_values.lengths.z;
  float found_m = float(side) * distance_m(cell, level);
  if (change <= 0.0) return max(found_m, 0.0);
  float band_m = distance_values.thresholds.y / change;
  for (int k = 1; k < 4; ++k) {
    int there = level - side * k;
    if (side > 0 && there < 0) break;  // lower than the lowest it never is
    found_m = float(side) * distance_m(cell, there);
    if (found_m < float(k) * band_m) return max(found_m, float(k - 1) * band_m);
  }
  return max(found_m, 0.0);
}

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  ivec3 size = distance_values.cells.xyz;
  if (texel.x >= size.x || texel.y >= size.y || texel.z >= size.z * distance_values.cells.w) return;
  int level = texel.z / size.z;
  ivec3 cell = texel - ivec3(0, 0, level * size.z);
  float slope_per_m = texelFetch(padded_slopes, cell, 0).x + distance_values.lengths.z;
  float change_m = distance_values.tile_m.w > 0.0 ? min(1.0 / max(slope_per_m, 1.0e-9), 60000.0) : 0.0;
  const float rounded_down = 0.999;  // as 16 bits may not
  float signed_m = reach_m(cell, level, 1) - reach_m(cell, level + 1, -1);  // the threshold lies between two levels
  imageStore(target, texel, rounded_down * vec4(signed_m, change_m, 0.0, 0.0));
}
