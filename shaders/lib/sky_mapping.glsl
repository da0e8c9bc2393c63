// How directions map to the sky tables.
#ifndef LIB_SKY_MAPPING
#define LIB_SKY_MAPPING
#include "lib/constants.glsl"

// Transmittance to space: x from the cosine to the vertical, fine about the horizon; y from the altitude, fine near the ground.
vec2 transmittance_uv(float altitude_m, float mu) {
  float x = mu < 0.0 ? -sqrt(-mu) : sqrt(mu);
  return vec2(0.5 + 0.5 * x, sqrt(clamp(altitude_m / atmosphere_top_m, 0.0, 1.0)));
}
float transmittance_mu(float u) {
  float x = 2.0 * u - 1.0;
  return x < 0.0 ? -x * x : x * x;
}
float transmittance_altitude_m(float v) { return v * v * atmosphere_top_m; }

// How far the horizon lies below the horizontal, radians.
float horizon_dip(float altitude_m) {
  return acos(clamp(planet_radius_m / (planet_radius_m + max(altitude_m, 0.0)), -1.0, 1.0));
}

// Sky view: x from the azimuth away from the sun, fine about the sun; y from the elevation, fine about the horizon
// (after Hillaire 2020, section 5.3). `cos_azimuth`: between the horizontal parts of the direction and of the sun's.
vec2 sky_view_uv(float elevation, float cos_azimuth, float dip) {
  float above = elevation + dip;
  float v = above >= 0.0 ? 0.5 + 0.5 * sqrt(above / (0.5 * pi + dip)) : 0.5 - 0.5 * sqrt(-above / (0.5 * pi - dip));
  return vec2(sqrt(acos(clamp(cos_azimuth, -1.0, 1.0)) / pi), v);
}
// The inverse: elevation and azimuth, radians.
vec2 sky_view_angles(vec2 uv, float dip) {
  float s = 2.0 * uv.y - 1.0;
  float elevation = s >= 0.0 ? s * s * (0.5 * pi + dip) - dip : -s * s * (0.5 * pi - dip) - dip;
  return vec2(elevation, pi * uv.x * uv.x);
}

// Bilinear tables hold their extremes at the middles of the outer texels.
vec2 table_uv(vec2 uv, vec2 size) { return (0.5 + clamp(uv, 0.0, 1.0) * (size - 1.0)) / size; }
vec2 table_parameter(vec2 pixel, vec2 size) { return pixel / (size - 1.0); }
#endif
