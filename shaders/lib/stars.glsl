// Stars from a seed: as many of each magnitude as the naked eye sees, and each where it is whatever the camera does.
#ifndef LIB_STARS
#define LIB_STARS
#include "lib/constants.glsl"
#include "lib/hash.glsl"

const float star_cells = 36.0;  // along the edge of a cube's face; 7776 stars a layer

// Irradiance of a star in units of one of magnitude 0: N(< m) grows as 10^(0.51 m) (Allen 1973, "Astrophysical Quantities", section 117,
// about magnitude 4). tuned: the faintest is of magnitude 6.9, so that two layers hold about 9000 stars brighter than 6.5.
float star_irradiance(float random) { return exp2(-1.3288 * (6.9 + log2(max(random, 1.0e-5)) * 0.5903)); }

// tuned: from orange to blue-white, white on average, as most bright stars are.
vec3 star_colour(float random) { return vec3(1.25 - 0.5 * random, 1.0, 0.7 + 0.6 * random); }

// A cube's face and the place on it, -1..1, where a direction leaves it; even in angle. z: the face.
vec3 cube_place(vec3 d) {
  vec3 a = abs(d);
  float face = a.x >= a.y && a.x >= a.z ? 0.0 : (a.y >= a.z ? 1.0 : 2.0);
  float along = face == 0.0 ? d.x : (face == 1.0 ? d.y : d.z);
  vec2 across = face == 0.0 ? vec2(d.y, d.z) : (face == 1.0 ? vec2(d.z, d.x) : vec2(d.x, d.y));
  return vec3(atan(across / abs(along)) * (4.0 / pi), 2.0 * face + (along < 0.0 ? 1.0 : 0.0));
}
vec3 cube_direction(vec3 place) {
  vec2 across = tan(vec2(place.x, place.y) * (0.25 * pi));
  float axis = floor(0.5 * place.z);
  float along = place.z > 2.0 * axis + 0.5 ? -1.0 : 1.0;
  vec3 d = axis == 0.0 ? vec3(along, across.x, across.y)
                       : (axis == 1.0 ? vec3(across.y, along, across.x) : vec3(across.x, across.y, along));
  return normalize(d);
}

// Radiance at a direction (unit, of the star sphere), in units of a star of magnitude 0 per steradian. Each cell holds one star, far
// enough from its edge for its image, a Gaussian of `sigma` radians: about a pixel, so that a star neither vanishes nor blinks.
vec3 star_radiance(vec3 d, uint layer, float sigma) {
  vec3 place = cube_place(d);
  vec2 cell = floor((vec2(place.x, place.y) * 0.5 + 0.5) * star_cells);
  uvec3 id = uvec3(uint(cell.x), uint(cell.y), uint(place.z) + 8u * layer);
  vec3 where = hash_unit(id);
  vec3 what = hash_unit(id + uvec3(101u, 211u, 307u));
  vec2 at = (cell + 0.25 + 0.5 * vec2(where.x, where.y)) / star_cells * 2.0 - 1.0;
  vec3 star = cube_direction(vec3(at, place.z));
  vec3 chord = d - star;
  float spread = min(sigma, 0.004);
  float image = exp(-0.5 * dot(chord, chord) / (spread * spread)) / (2.0 * pi * spread * spread);
  return star_colour(what.y) * (star_irradiance(what.x) * image);
}
#endif
