// A clear atmosphere: coefficients and densities (Hillaire 2020, "A Scalable and Production Ready Sky and Atmosphere Rendering
// Technique", table 1; the released code's aerosol). `haze` scales the aerosol.
#ifndef LIB_ATMOSPHERE
#define LIB_ATMOSPHERE
#include "lib/constants.glsl"
#include "lib/intersect.glsl"

const float rayleigh_scale_m = 8000.0;
const float aerosol_scale_m = 1200.0;
const float aerosol_asymmetry_g = 0.8;

vec3 rayleigh_scattering_per_m() { return vec3(5.802e-6, 13.558e-6, 33.1e-6); }
float aerosol_scattering_per_m() { return 3.996e-6; }
float aerosol_extinction_per_m() { return 4.44e-6; }
vec3 ozone_absorption_per_m() { return vec3(0.650e-6, 1.881e-6, 0.085e-6); }

float rayleigh_density(float altitude_m) { return exp(-max(altitude_m, 0.0) / rayleigh_scale_m); }
float aerosol_density(float altitude_m) { return exp(-max(altitude_m, 0.0) / aerosol_scale_m); }
float ozone_density(float altitude_m) { return max(0.0, 1.0 - abs(altitude_m - 25000.0) / 15000.0); }

vec3 atmosphere_extinction_per_m(float altitude_m, float haze) {
  return rayleigh_scattering_per_m() * rayleigh_density(altitude_m) +
         vec3(haze * aerosol_extinction_per_m() * aerosol_density(altitude_m)) +
         ozone_absorption_per_m() * ozone_density(altitude_m);
}

// Mean of exp(-h / scale) between two altitudes; from the lower one up, so that no power overflows.
float mean_exponential(float a_m, float b_m, float scale_m) {
  float d = abs(b_m - a_m) / scale_m;
  float start = exp(-max(min(a_m, b_m), 0.0) / scale_m);
  return d < 1.0e-3 ? start * (1.0 - 0.5 * d) : start * (1.0 - exp(-d)) / d;
}

// Optical depth of the air between two altitudes along a path, ozone left out (it lies above the clouds).
vec3 air_optical_depth(float from_altitude_m, float to_altitude_m, float distance_m, float haze) {
  float rayleigh = mean_exponential(from_altitude_m, to_altitude_m, rayleigh_scale_m);
  float aerosol = mean_exponential(from_altitude_m, to_altitude_m, aerosol_scale_m);
  return distance_m * (rayleigh_scattering_per_m() * rayleigh + vec3(haze * aerosol_extinction_per_m() * aerosol));
}

// Transmittance from `altitude_m` to space along a direction with cosine `mu` to the vertical; 0 if the planet is in the way.
vec3 transmittance_to_space(float altitude_m, float mu, float haze, int steps) {
  vec3 origin = vec3(0.0, 0.0, max(altitude_m, 0.0));
  vec3 direction = vec3(sqrt(max(0.0, 1.0 - mu * mu)), 0.0, mu);
  vec2 ground = intersect_altitude(origin, direction, -10.0);
  if (ground.x <= ground.y && ground.x > 0.0) return vec3(0.0);
  vec2 top = intersect_altitude(origin, direction, atmosphere_top_m);
  vec3 optical_depth = vec3(0.0);
  float previous_m = 0.0;
  for (int i = 0; i < steps; ++i) {  // steps grow with the square: the air is thin far away
    float x = float(i + 1) / float(steps);
    float next_m = top.y * x * x;
    vec3 p = origin + direction * (0.5 * (previous_m + next_m));
    float r = sqrt(p.x * p.x + (p.z + planet_radius_m) * (p.z + planet_radius_m));
    optical_depth += atmosphere_extinction_per_m(r - planet_radius_m, haze) * (next_m - previous_m);
    previous_m = next_m;
  }
  return exp(-optical_depth);
}
#endif
