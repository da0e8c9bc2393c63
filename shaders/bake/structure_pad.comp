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
  for (int i = 0; i < 27; ++i) {
    ivec3 near = cell + ivec3(i % 3, (i / 3) % 3, i / 9) - 1;
    near.xy = (near.xy + cells.xy) % cells.xy;
    if (near.z < 0 || near.z >= cells.z) continue;
    greatest = max(greatest, texelFetch(unpadded, near, 0).x);
  }
  imageStore(target, cell, vec4(greatest, texelFetch(unpadded, cell, 0).x, 0.0, 0.0));
}
