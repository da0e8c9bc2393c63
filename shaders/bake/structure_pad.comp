// Pads the structure by one cell all round: east and north across the tile's edge, up and down within it. Beside it (y) stays what it
// was with a layer of padding less.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "shared/structure_block.glsl"
layout(binding = 0, rg32f) uniform writeonly image3D target;
layout(binding = 0) uniform sampler3D unpadded;

void main() {
  ivec3 cell = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  ivec3 cells = structure_values.size.xyz;
  if (cell.x >= cells.x || cell.y >= cells.y || cell.z >= cells.z) return;
  float greatest = 0.0;
  ivec2 before = cell.xy - 1 + cells.xy * ivec2(equal(cell.xy, ivec2(0)));
  ivec2 after = cell.xy + 1 - cells.xy * ivec2(equal(cell.xy, cells.xy - 1));
  ivec3 x = ivec3(before.x, cell.x, after.x), y = ivec3(before.y, cell.y, after.y);
  for (int z = max(cell.z - 1, 0); z <= min(cell.z + 1, cells.z - 1); ++z)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) greatest = max(greatest, texelFetch(unpadded, ivec3(x[i], y[j], z), 0).x);
  imageStore(target, cell, vec4(greatest, texelFetch(unpadded, cell, 0).x, 0.0, 0.0));
}
