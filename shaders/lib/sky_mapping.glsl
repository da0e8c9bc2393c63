// How altitudes, directions and distances map to the sky tables, 0..1 each.
#ifndef LIB_SKY_MAPPING
#define LIB_SKY_MAPPING
#include "lib/atmosphere.glsl"
#include "lib/constants.glsl"

// Transmittance to space: x from the way to the top of the atmosphere, between the shortest and the way past the horizon; y from the
// way to the horizon (Bruneton 2017, "Precomputed Atmospheric Scattering: a New Implementation", section on transmittance).
vec2 transmittance_uv(float altitude_m, float mu) {
  float h = clamp(altitude_m, 0.0, atmosphere_top_m);
  float b = (planet_radius_m + h) * mu;
  float way_m = sqrt(max(0.0, b * b + (atmosphere_top_m - h) * (atmosphere_top_m + h + 2.0 * planet_radius_m))) - b;
  float shortest_m = atmosphere_top_m - h;
  float horizon_m = horizon_distance_m(h);
  float whole_m = horizon_distance_m(atmosphere_top_m);
  return vec2((way_m - shortest_m) / (horizon_m + whole_m - shortest_m), horizon_m / whole_m);
}
float transmittance_altitude_m(float y) {
  float horizon_m = y * horizon_distance_m(atmosphere_top_m);
  return horizon_m * horizon_m / (sqrt(horizon_m * horizon_m + planet_radius_m * planet_radius_m) + planet_radius_m);
}
float transmittance_mu(float x, float altitude_m) {
  float whole_m = horizon_distance_m(atmosphere_top_m);
  float horizon_m = horizon_distance_m(altitude_m);
  float way_m = mix(atmosphere_top_m - altitude_m, horizon_m + whole_m, x);
  if (way_m <= 0.0) return 1.0;
  return clamp((whole_m * whole_m - horizon_m * horizon_m - way_m * way_m) / (2.0 * (planet_radius_m + altitude_m) * way_m), -1.0, 1.0);
}

// Light scattered more than once: x from the light's cosine to the vertical, fine about the horizon, down to 24 degrees below it; y from
// the altitude, fine near the ground.
const float lowest_light_root = 0.64;
vec2 multiple_uv(float altitude_m, float mu) {
  float root = mu < 0.0 ? -sqrt(-mu) : sqrt(mu);
  return vec2((root + lowest_light_root) / (1.0 + lowest_light_root), sqrt(clamp(altitude_m / atmosphere_top_m, 0.0, 1.0)));
}
float multiple_mu(float x) {
  float root = x * (1.0 + lowest_light_root) - lowest_light_root;
  return root * abs(root);
}
float multiple_altitude_m(float y) { return y * y * atmosphere_top_m; }

// Azimuth without trigonometry: horizontal parts of a direction along and across that of the light. mirrored: both sides are alike.
float azimuth_coordinate(float along, float across, bool mirrored) {
  float turn = 1.0 - along / max(abs(along) + abs(across), 1.0e-9);  // 0: towards the light, 2: away from it
  if (mirrored) return 0.5 * turn;
  return across < 0.0 ? 0.5 - 0.25 * turn : 0.5 + 0.25 * turn;
}
// The inverse: a unit vector, along and across.
vec2 azimuth_direction(float coordinate, bool mirrored) {
  float turn = mirrored ? 2.0 * coordinate : 4.0 * abs(coordinate - 0.5);
  float along = 1.0 - turn;
  float across = 1.0 - abs(along);
  return normalize(vec2(along, !mirrored && coordinate < 0.5 ? -across : across));
}

// Sky view: from the sine of the elevation, fine about the horizon (after Hillaire 2020, section 5.3); nothing below it.
// `dip_sine` is horizon_sine of the camera's altitude.
float sky_view_v(float sine, float dip_sine) { return sqrt(clamp((sine + dip_sine) / (1.0 + dip_sine), 0.0, 1.0)); }
float sky_view_sine(float v, float dip_sine) { return v * v * (1.0 + dip_sine) - dip_sine; }

// Aerial perspective: from the sine of the elevation, fine about the horizon, and from the distance.
float aerial_v(float sine, float dip_sine) {
  float above = sine + dip_sine;
  return above < 0.0 ? 0.5 - 0.5 * sqrt(-above / (1.0 - dip_sine)) : 0.5 + 0.5 * sqrt(above / (1.0 + dip_sine));
}
float aerial_sine(float v, float dip_sine) {
  float s = 2.0 * v - 1.0;
  return s * abs(s) * (s < 0.0 ? 1.0 - dip_sine : 1.0 + dip_sine) - dip_sine;
}
// Distances count from where the ray comes below this altitude, or passes closest to it: above there is little air, and no cloud.
const float aerial_ceiling_m = 16000.0;
float aerial_begin_m(float altitude_m, vec3 direction) {
  if (altitude_m <= aerial_ceiling_m) return 0.0;
  vec2 below = intersect_altitude(vec3(0.0, 0.0, altitude_m), direction, aerial_ceiling_m);
  if (below.x <= below.y && below.x > 0.0) return below.x;
  return max(0.0, -(planet_radius_m + altitude_m) * direction.z);
}
const float aerial_scale_m = 40000.0;  // tuned: half of the slices lie within it
const float aerial_farthest = 0.98;      // 49 times the scale
float aerial_w(float distance_m) { return min(distance_m / (distance_m + aerial_scale_m) / aerial_farthest, 1.0); }
float aerial_distance_m(float w) { return aerial_scale_m * aerial_farthest * w / (1.0 - aerial_farthest * w); }

// Linear tables hold their extremes at the middles of the outer texels.
float table_u(float u, float size) { return (0.5 + clamp(u, 0.0, 1.0) * (size - 1.0)) / size; }
vec2 table_uv(vec2 uv, vec2 size) { return (0.5 + clamp(uv, 0.0, 1.0) * (size - 1.0)) / size; }
vec2 table_parameter(vec2 pixel, vec2 size) { return pixel / (size - 1.0); }
#endif
