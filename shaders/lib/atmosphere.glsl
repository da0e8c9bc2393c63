// A clear atmosphere of air, aerosol and ozone: coefficients and densities (Hillaire 2020, "A Scalable and Production Ready Sky and
// Atmosphere Rendering Technique", table 1; of the aerosol the released code's extinction, 4.44e-6 in all, where the table prints
// that number as absorption alone).
//
// Its colours are 680, 550 and 440 nm, which shown as red, green and blue make noon too deep a blue and twilight violet, for ozone
// takes little at 680 nm. Ours are the means over the spectrum that linear sRGB sees of sunlight: the same scattering as the table's at
// 550 nm (with 1 / wavelength^4) and its ozone (Bruneton 2017, cross sections of Serdyuchenko et al.), weighted by sunlight (ASTM G-173)
// and the CIE 1931 functions. tests/unit/shaders/spectrum_test.cpp repeats that.
#ifndef LIB_ATMOSPHERE
#define LIB_ATMOSPHERE
#include "lib/constants.glsl"
#include "lib/intersect.glsl"

// What a document can change of it. rayleigh, haze and ozone are factors on the amounts.
struct Atmosphere {
  float rayleigh, haze, ozone;
  float aerosol_scale_m, aerosol_asymmetry_g;
};

const float rayleigh_scale_m = 8000.0;

vec3 rayleigh_scattering_per_m() { return vec3(7.18e-6, 13.73e-6, 32.22e-6); }
float aerosol_scattering_per_m() { return 3.996e-6; }
float aerosol_extinction_per_m() { return 4.44e-6; }
vec3 ozone_absorption_per_m() { return vec3(2.487e-6, 1.795e-6, 0.0); }

float exponential_density(float altitude_m, float scale_m) { return exp(-max(altitude_m, 0.0) / scale_m); }
float ozone_density(float altitude_m) { return max(0.0, 1.0 - abs(altitude_m - 25000.0) / 15000.0); }

// Scattering and extinction at a point, 1/m.
struct AirAt {
  vec3 rayleigh;
  float aerosol;
  vec3 extinction;
};

AirAt air_at(float altitude_m, Atmosphere air) {
  vec3 rayleigh = rayleigh_scattering_per_m() * (air.rayleigh * exponential_density(altitude_m, rayleigh_scale_m));
  float aerosol = air.haze * exponential_density(altitude_m, air.aerosol_scale_m);
  return AirAt(rayleigh, aerosol * aerosol_scattering_per_m(),
               rayleigh + vec3(aerosol * aerosol_extinction_per_m()) +
                   ozone_absorption_per_m() * (air.ozone * ozone_density(altitude_m)));
}

// How far the horizon lies: metres from `altitude_m` to where the line of sight touches sea level.
float horizon_distance_m(float altitude_m) {
  float h = max(altitude_m, 0.0);
  return sqrt(h * (h + 2.0 * planet_radius_m));
}
// Sine and cosine of how far it lies below the horizontal.
float horizon_sine(float altitude_m) { return horizon_distance_m(altitude_m) / (planet_radius_m + max(altitude_m, 0.0)); }
float horizon_cosine(float altitude_m) { return planet_radius_m / (planet_radius_m + max(altitude_m, 0.0)); }

// Share of a disc of `radius` (radians) above the horizon, its middle at cosine `mu` to the vertical.
float disc_above_horizon(float altitude_m, float mu, float radius) {
  return smoothstep(-radius, radius, (mu + horizon_sine(altitude_m)) / horizon_cosine(altitude_m));
}

// Where steps of equal share end along a path, 0..1: fine where the air is dense, which is near its beginning, or, where it goes
// down and up again, about its lowest point. `evenness` (path_evenness): 0 for the first, 1 for the second.
float path_share(float share, float evenness) { return share * mix(share, 1.0, evenness); }
float path_evenness(float altitude_m, float mu, float length_m) {
  return clamp(-2.0 * (planet_radius_m + altitude_m) * mu / max(length_m, 1.0), 0.0, 1.0);
}

// Transmittance from `altitude_m` to space along a direction with cosine `mu` to the vertical; the planet is no obstacle.
vec3 transmittance_to_space(float altitude_m, float mu, Atmosphere air, int steps) {
  vec3 origin = vec3(0.0, 0.0, max(altitude_m, 0.0));
  vec3 direction = vec3(sqrt(max(0.0, 1.0 - mu * mu)), 0.0, mu);
  float length_m = max(0.0, intersect_altitude(origin, direction, atmosphere_top_m).y);
  float evenness = path_evenness(origin.z, mu, length_m);
  vec3 optical_depth = vec3(0.0);
  float previous_m = 0.0;
  for (int i = 0; i < steps; ++i) {
    float next_m = length_m * path_share(float(i + 1) / float(steps), evenness);
    vec3 p = origin + direction * (0.5 * (previous_m + next_m));
    optical_depth += air_at(altitude_far_of(p), air).extinction * (next_m - previous_m);
    previous_m = next_m;
  }
  return exp(-optical_depth);
}
#endif
