// Improved Perlin noise (Perlin 2002, "Improving Noise") on a lattice that repeats. The includer defines
// `int permutation(int index)`, 0 <= index < 256, a permutation of 0..255.
#ifndef LIB_PERLIN
#define LIB_PERLIN
#include "lib/around_edges.glsl"
int permutation(int index);

float perlin_fade(float t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

// One of the 12 edge gradients, dotted with the offset from the lattice point.
float perlin_gradient(int hash, float x, float y, float z) {
  int h = hash & 15;
  float u = h < 8 ? x : y;
  float v = h < 4 ? y : (h == 12 || h == 14 ? x : z);
  return ((h & 1) == 0 ? u : -u) + ((h & 2) == 0 ? v : -v);
}

int perlin_hash(ivec3 lattice) {
  return permutation((permutation((permutation(lattice.x & 255) + lattice.y) & 255) + lattice.z) & 255);
}

// Value in about [-1, 1] at `position` (lattice units, not negative); the lattice repeats after `period` points (at most 256 each).
float perlin_noise(vec3 position, ivec3 period) {
  ivec3 cell = ivec3(floor(position));
  vec3 f = position - floor(position);
  ivec3 a = ivec3(cell.x % period.x, cell.y % period.y, cell.z % period.z);
  ivec3 b = around_edges(a + 1, period);
  float u = perlin_fade(f.x);
  float v = perlin_fade(f.y);
  float w = perlin_fade(f.z);
  float g000 = perlin_gradient(perlin_hash(a), f.x, f.y, f.z);
  float g100 = perlin_gradient(perlin_hash(ivec3(b.x, a.y, a.z)), f.x - 1.0, f.y, f.z);
  float g010 = perlin_gradient(perlin_hash(ivec3(a.x, b.y, a.z)), f.x, f.y - 1.0, f.z);
  float g110 = perlin_gradient(perlin_hash(ivec3(b.x, b.y, a.z)), f.x - 1.0, f.y - 1.0, f.z);
  float g001 = perlin_gradient(perlin_hash(ivec3(a.x, a.y, b.z)), f.x, f.y, f.z - 1.0);
  float g101 = perlin_gradient(perlin_hash(ivec3(b.x, a.y, b.z)), f.x - 1.0, f.y, f.z - 1.0);
  float g011 = perlin_gradient(perlin_hash(ivec3(a.x, b.y, b.z)), f.x, f.y - 1.0, f.z - 1.0);
  float g111 = perlin_gradient(perlin_hash(b), f.x - 1.0, f.y - 1.0, f.z - 1.0);
  return mix(mix(mix(g000, g100, u), mix(g010, g110, u), v), mix(mix(g001, g101, u), mix(g011, g111, u), v), w);
}

// fBm in [0, 1], 1/2 on average: octaves of rising frequency and falling amplitude (Olajos 2.2.3). `position` in 0..1 over the
// tile, `frequency` lattice cells along each side of it.
float perlin_fbm(vec3 position, ivec3 frequency, int octaves, int lacunarity, float gain) {
  float sum = 0.0;
  float amplitude = 1.0;
  float total = 0.0;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += amplitude * perlin_noise(position * vec3(frequency), frequency);
    total += amplitude;
    amplitude *= gain;
    frequency *= lacunarity;
  }
  return clamp(0.5 + 0.5 * sum / total, 0.0, 1.0);
}
#endif
