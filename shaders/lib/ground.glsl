// The look of the plain ground: patches of land, as a factor on the albedo.
#ifndef LIB_GROUND
#define LIB_GROUND
#include "lib/hash.glsl"

// Smooth noise in 0..1 with cells of `cell_m` (a power of two); repeats every 65536 m.
float ground_noise(vec2 position_m, float cell_m, uint salt) {
  vec2 p = position_m / cell_m;
  vec2 f = p - floor(p);
  vec2 s = f * f * (3.0 - 2.0 * f);
  uint mask = uint(65536.0 / cell_m) - 1u;
  uint x = uint(int(floor(p.x))) & mask;
  uint y = uint(int(floor(p.y))) & mask;
  uint x1 = (x + 1u) & mask;
  uint y1 = (y + 1u) & mask;
  float a = mix(hash_unit(uvec3(x, y, salt)).x, hash_unit(uvec3(x1, y, salt)).x, s.x);
  float b = mix(hash_unit(uvec3(x, y1, salt)).x, hash_unit(uvec3(x1, y1, salt)).x, s.x);
  return mix(a, b, s.y);
}

// How much of a pattern of `cell_m` survives in a picture whose pixels cover `footprint_m`.
float pattern_contrast(float cell_m, float footprint_m) { return clamp(1.5 - 3.0 * footprint_m / cell_m, 0.0, 1.0); }

// Factor on the albedo, 1 on average: woods and meadows in patches of kilometres to tens of metres. tuned: to look at.
vec3 ground_tint(vec2 position_m, float footprint_m, float variation) {
  float hills = ground_noise(position_m, 4096.0, 1u) - 0.5;
  float woods = 0.0;
  if (footprint_m < 512.0) {
    float raw = ground_noise(position_m, 1024.0, 2u) * 0.6 + ground_noise(position_m, 256.0, 3u) * 0.4;
    woods = (smoothstep(0.42, 0.58, raw) - 0.5) * pattern_contrast(1024.0, footprint_m);
  }
  float grain = 0.0;
  if (footprint_m < 30.0) grain = (ground_noise(position_m, 64.0, 4u) - 0.5) * pattern_contrast(64.0, footprint_m);
  vec3 tint = vec3(1.0) + hills * vec3(0.5, 0.35, 0.25) + woods * vec3(1.0, 0.7, 0.6) + grain * vec3(0.3, 0.3, 0.3);
  return mix(vec3(1.0), max(tint, vec3(0.1)), variation);
}
#endif
