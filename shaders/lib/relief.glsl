// Mountains from integers: noise with its slope, and gullies that run down a slope. All repeat after `cells` lattice cells.
#ifndef LIB_RELIEF
#define LIB_RELIEF
#include "lib/constants.glsl"
#include "lib/hash.glsl"

// Two numbers in -1..1 for a lattice cell.
vec2 relief_vector(int x, int y, int cells, uint salt) {
  uint east = uint(x - cells * int(floor(float(x) / float(cells))));
  uint north = uint(y - cells * int(floor(float(y) / float(cells))));
  vec3 random = hash_unit(uvec3(east, north, salt));
  return vec2(random.x, random.y) * 2.0 - 1.0;
}

// Gradient noise (Perlin 2002) with its derivative: value within about -0.7..0.7, slope east and north per cell.
vec3 relief_noise(vec2 p, int cells, uint salt) {
  vec2 corner = floor(p);
  vec2 f = p - corner;
  int x = int(corner.x);
  int y = int(corner.y);
  vec2 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  vec2 du = 30.0 * f * f * (f * (f - 2.0) + 1.0);
  vec2 ga = relief_vector(x, y, cells, salt);
  vec2 gb = relief_vector(x + 1, y, cells, salt);
  vec2 gc = relief_vector(x, y + 1, cells, salt);
  vec2 gd = relief_vector(x + 1, y + 1, cells, salt);
  float a = dot(ga, f);
  float b = dot(gb, f - vec2(1.0, 0.0));
  float c = dot(gc, f - vec2(0.0, 1.0));
  float d = dot(gd, f - vec2(1.0, 1.0));
  float k = a - b - c + d;
  vec2 slope = ga + u.x * (gb - ga) + u.y * (gc - ga) + u.x * u.y * (ga - gb - gc + gd) +
               du * vec2(b - a + u.y * k, c - a + u.x * k);
  return vec3(a + u.x * (b - a) + u.y * (c - a) + u.x * u.y * k, slope.x, slope.y);
}

// Crests where the noise crosses zero, rounded over `rounding`: 0..1, with its slope.
vec3 relief_ridges(vec3 noise, float rounding) {
  float smooth_abs = sqrt(noise.x * noise.x + rounding * rounding);
  return vec3(1.0 - 2.0 * smooth_abs, -2.0 * noise.x / smooth_abs * noise.y, -2.0 * noise.x / smooth_abs * noise.z);
}

// Waves of one cell's length whose crests run along `down` (a unit vector), out of phase from cell to cell, so that they begin,
// end and join as gullies do: -1..1, with the slope. Each cell's wave fades out over 1.25 cells.
vec3 relief_gullies(vec2 p, vec2 down, int cells, uint salt) {
  vec2 side = vec2(-down.y, down.x) * (2.0 * pi);
  vec2 corner = floor(p);
  vec3 sum = vec3(0.0);
  float weights = 1.0e-4;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      int x = int(corner.x) + i;
      int y = int(corner.y) + j;
      vec2 at = p - (vec2(float(x), float(y)) + 0.5 + 0.25 * relief_vector(x, y, cells, salt));
      float w = max(0.0, 1.0 - dot(at, at) / 1.5625);
      w *= w;
      float angle = dot(at, side);
      float steep = -sin(angle);
      sum += w * vec3(cos(angle), steep * side.x, steep * side.y);
      weights += w;
    }
  }
  return sum / weights;
}

// The first root within 0..1 of the parabola through `begin` > 0, `middle` and `end` at 0, 1/2 and 1; 2 where there is none.
float first_root(float begin, float middle, float end) {
  float b = 4.0 * middle - 3.0 * begin - end;
  float a = 2.0 * (begin + end) - 4.0 * middle;
  float discriminant = b * b - 4.0 * a * begin;
  if (discriminant < 0.0) return 2.0;
  float denominator = sqrt(discriminant) - b;
  return denominator > 0.0 ? min(2.0, 2.0 * begin / denominator) : 2.0;
}
#endif
