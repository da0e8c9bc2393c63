// The greatest of each block of 8^3 majorants (server/bake/majorants.h), so that empty air can be crossed in large steps.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(binding = 0, r32f) uniform writeonly image3D target;
layout(binding = 0) uniform sampler3D fine;

const int block_side = 8;

void main() {
  ivec3 cell = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  if (any(greaterThanEqual(cell, imageSize(target)))) return;
  ivec3 last = min((cell + 1) * block_side, textureSize(fine, 0)) - 1;
  float greatest = 0.0;
  for (int z = cell.z * block_side; z <= last.z; ++z)
    for (int y = cell.y * block_side; y <= last.y; ++y)
      for (int x = cell.x * block_side; x <= last.x; ++x) greatest = max(greatest, texelFetch(fine, ivec3(x, y, z), 0).x);
  imageStore(target, cell, vec4(greatest));
}
