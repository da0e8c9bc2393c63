// Deterministic random numbers from integers.
#ifndef LIB_HASH
#define LIB_HASH

// pcg3d: three well-mixed words from three (Jarzynski and Olano 2020, "Hash Functions for GPU Rendering", listing 16).
uvec3 pcg3d(uvec3 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v = v ^ (v >> 16u);
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v;
}

// Three numbers in [0, 1).
vec3 hash_unit(uvec3 v) { return vec3(pcg3d(v) >> 8u) * (1.0 / 16777216.0); }

// Interleaved gradient noise in [0, 1): neighbouring pixels differ as much as they can (Jimenez 2014, "Next generation post
// processing in Call of Duty").
float interleaved_gradient_noise(vec2 pixel) {
  return fract(52.9829189 * fract(0.06711056 * pixel.x + 0.00583715 * pixel.y));
}
#endif
