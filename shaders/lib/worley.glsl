// Cellular noise (Worley 1996) with one feature point a cell, on cells that repeat (Olajos 2.2.2).
#ifndef LIB_WORLEY
#define LIB_WORLEY
#include "lib/around_edges.glsl"
#include "lib/hash.glsl"

// The feature point of a cell, in 0..1 of the cell.
vec3 worley_point(ivec3 cell, uint seed) {
  return hash_unit(uvec3(uint(cell.x), uint(cell.y), uint(cell.z) ^ (seed * 747796405u + 2891336453u)));
}

// 1 - d / sqrt(3), in [0, 1]: 1 at a feature point. The nearest point lies in the 3x3x3 neighbourhood. `position` in cells, not
// negative; the cells repeat after `period`.
float worley_noise(vec3 position, ivec3 period, uint seed) {
  ivec3 cell = ivec3(floor(position)) % period;  // software divides integers one by one: not once more for each neighbour
  vec3 f = position - floor(position);
  float nearest2 = 3.0;
  for (int z = -1; z <= 1; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        ivec3 wrapped = around_edges(cell + ivec3(x, y, z), period);
        vec3 offset = vec3(float(x), float(y), float(z)) + worley_point(wrapped, seed) - f;
        nearest2 = min(nearest2, dot(offset, offset));
      }
    }
  }
  return 1.0 - sqrt(nearest2 / 3.0);
}

// fBm in [0, 1]. `position` in 0..1 over the tile, `frequency` cells along each side of it; every octave has feature points of its own.
float worley_fbm(vec3 position, ivec3 frequency, int octaves, int lacunarity, float gain, uint seed) {
  float sum = 0.0;
  float amplitude = 1.0;
  float total = 0.0;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += amplitude * worley_noise(position * vec3(frequency), frequency, seed + uint(octave) * 101u);
    total += amplitude;
    amplitude *= gain;
    frequency *= lacunarity;
  }
  return sum / total;
}
#endif
