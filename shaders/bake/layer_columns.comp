// The greatest shape of each column of a layer, as far as its slices are baked.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "shared/bake_block.glsl"
layout(binding = 0, r32f) uniform image3D target;
layout(binding = 0) uniform sampler3D layer_shape;

void main() {
  ivec3 column = ivec3(gl_GlobalInvocationID);
  if (column.z > 0 || any(greaterThanEqual(column.xy, imageSize(target).xy))) return;
  float greatest = imageLoad(target, column).x;
  for (int z = bake.slices.z; z < bake.slices.y; ++z) greatest = max(greatest, texelFetch(layer_shape, ivec3(column.xy, z), 0).x);
  imageStore(target, column, vec4(greatest));
}
