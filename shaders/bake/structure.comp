// Bakes the unpadded structure (Olajos 2.4.2): for each cell the greatest shape noise that interpolation can give in it, and as far
// beyond its faces as it is to reach; beside it (y) the greatest density of the layers there, or the least noise, or 1.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "shared/structure_block.glsl"
#include "lib/around_edges.glsl"
layout(binding = 0, rg32f) uniform writeonly image3D target;
layout(binding = 0) uniform sampler3D shape_texture;

ivec3 inside(ivec3 texel, ivec3 size) { return clamp(around_edges(texel, size), ivec3(0), size - 1); }

// Shape (x), what the finer channels make of it (y) and density (z), the greatest and the least of some texels.
struct Range {
  vec3 most, least;
};
Range both(Range a, Range b) { return Range(max(a.most, b.most), min(a.least, b.least)); }

// Of the four texels of a cube's face.
Range face_range(ivec3 at, ivec3 size) {
  Range range = Range(vec3(-1.0e9), vec3(1.0e9));
  for (int i = 0; i < 4; ++i) {
    vec4 noise = texelFetch(shape_texture, inside(at + ivec3(0, i & 1, i >> 1), size), 0);
    vec3 texel = vec3(noise.x, 1.0 + dot(structure_values.weights.yzw, noise.yzw - 0.5), noise.y);
    range = both(range, Range(texel, texel));
  }
  return range;
}

void main() {
  ivec3 cell = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  ivec3 cells = structure_values.size.xyz;
  if (cell.x >= cells.x || cell.y >= cells.y || cell.z >= cells.z) return;
  // Around the edges in all directions: where the shape is clamped there, the march finds no more than that.
  ivec3 size = textureSize(shape_texture, 0);
  // The cubes of eight texel middles that reach into the cell.
  float reach = structure_values.reach.x;
  ivec3 first = ivec3(floor((vec3(cell) - reach) * vec3(size) / vec3(cells) - 0.5));
  ivec3 last = ivec3(ceil((vec3(cell + 1) + reach) * vec3(size) / vec3(cells) - 0.5)) - 1;
  float greatest = 0.0, least = 1.0e9, densest = 0.0;
  for (int z = first.z; z <= last.z; ++z) {
    for (int y = first.y; y <= last.y; ++y) {
      Range face = face_range(ivec3(first.x, y, z), size);
      for (int x = first.x; x <= last.x; ++x) {
        // The channels are interpolated one by one, and then multiplied: no more than the product of their maxima.
        Range next = face_range(ivec3(x + 1, y, z), size);
        Range cube = both(face, next);
        greatest = max(greatest, cube.most.x * max(cube.most.y, 0.0));
        least = min(least, cube.least.x * max(cube.least.y, 0.0));
        densest = max(densest, cube.most.z);
        face = next;
      }
    }
  }
  imageStore(target, cell, vec4(greatest, structure_values.reach.z > 0.0 ? least : structure_values.reach.y > 0.0 ? densest : 1.0, 0.0, 0.0));
}
