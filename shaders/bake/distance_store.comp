// What the march looks up: for each level of the threshold, one above the other, how far a point of a cell is from cloud wherever the land
// may lower the threshold on the way (m); how far the noise takes to change by 1, in the cell and those about it (m).
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "shared/distance_block.glsl"
layout(binding = 0, rg16f) uniform writeonly image3D target;
layout(binding = 0) uniform sampler3D squares;  // of a level in each channel
layout(binding = 1) uniform sampler3D padded_slopes;

float distance_m(ivec3 cell, int level) { return sqrt(texelFetch(squares, cell, 0)[level]); }

// Within the first `spacing / fall` metres the threshold can come down to the next lower level, and so on; below the lowest it never is.
float free_m(ivec3 cell, int level) {
  float fall = distance_values.lengths.z;
  if (fall <= 0.0) return distance_m(cell, level);
  float band_m = distance_values.thresholds.y / fall;
  for (int k = 1; k <= level; ++k) {
    float found_m = distance_m(cell, level - k);
    if (found_m < float(k) * band_m) return max(found_m, float(k - 1) * band_m);
  }
  return distance_m(cell, 0);
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
  imageStore(target, texel, rounded_down * vec4(free_m(cell, level), change_m, 0.0, 0.0));
}
