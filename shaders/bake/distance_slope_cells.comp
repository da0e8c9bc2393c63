// The steepest slope of the shape noise in each cell (1/m).
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "shared/distance_block.glsl"
#include "lib/around_edges.glsl"
layout(binding = 0, rg32f) uniform writeonly image3D target;
layout(binding = 0) uniform sampler3D slopes;

void main() {
  ivec3 cell = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  ivec3 cells = distance_values.cells.xyz;
  if (any(greaterThanEqual(cell, cells))) return;
  ivec3 size = textureSize(slopes, 0);
  // The cubes that reach into the cell begin half a texel before their texels' faces.
  ivec3 first = ivec3(floor(vec3(cell * size) / vec3(cells) - 0.5));
  ivec3 last = ivec3(ceil(vec3((cell + 1) * size) / vec3(cells) - 0.5)) - 1;
  float steepest = 0.0;
  for (int z = first.z; z <= last.z; ++z)
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x)
        steepest = max(steepest, texelFetch(slopes, around_edges(ivec3(x, y, z), size), 0).x);
  imageStore(target, cell, vec4(steepest));
}
