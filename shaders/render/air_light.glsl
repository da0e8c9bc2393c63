// Light that the air scatters towards a camera, for the passes that bake the sky tables.
#ifndef RENDER_AIR_LIGHT
#define RENDER_AIR_LIGHT
#include "render/air.glsl"
#include "lib/phase.glsl"
layout(binding = 9) uniform sampler2D multiple_table;

vec3 multiple_scattering(float altitude_m, float mu) {
  return textureLod(multiple_table, table_uv(multiple_uv(altitude_m, mu), multiple_size), 0.0).xyz;
}

// Radiance scattered per metre. Apart from `even`: what the aerosol scatters of the light itself, before its phase function, which
// is sharp.
struct AirLight {
  vec3 even, aerosol;
};

AirLight air_light(AirAt air, vec3 p, float altitude_m, vec3 direction) {
  vec3 up = vec3(p.xy, p.z + planet_radius_m) / (altitude_m + planet_radius_m);
  AirLight light = AirLight(vec3(0.0), vec3(0.0));
  for (int i = 0; i < frame.sample_info.z; ++i) {
    vec4 towards = i == 0 ? frame.light_direction : frame.second_direction;
    vec3 irradiance = i == 0 ? frame.light_irradiance.xyz : frame.second_irradiance.xyz;
    float mu = dot(up, towards.xyz);
    float cos_theta = dot(direction, towards.xyz);
    vec3 direct = irradiance * light_transmittance(altitude_m, mu, towards.w);
    light.even += air.rayleigh * phase_rayleigh(cos_theta) * direct +
                  (air.rayleigh + vec3(air.aerosol)) * multiple_scattering(altitude_m, mu) * irradiance;
    if (i == 0) light.aerosol += air.aerosol * direct;
    if (i == 1) light.even += air.aerosol * phase_cornette_shanks(cos_theta, frame.aerosol.x) * direct;
  }
  return light;
}

struct AirMarch {
  vec3 even, aerosol, transmittance;
};

// One step of a march, `step_m` about p.
AirMarch air_step(AirMarch march, vec3 p, vec3 direction, float step_m) {
  float altitude_m = altitude_far_of(p);
  AirAt air = air_at(altitude_m, frame_atmosphere());
  AirLight light = air_light(air, p, max(altitude_m, 0.0), direction);
  vec3 step_transmittance = exp(-air.extinction * step_m);
  vec3 share = march.transmittance * (1.0 - step_transmittance) / max(air.extinction, vec3(1.0e-12));
  march.even += share * light.even;
  march.aerosol += share * light.aerosol;
  march.transmittance *= step_transmittance;
  return march;
}

// From `begin_m` to `end_m` along a ray from the point `altitude_m` above the sea.
AirMarch march_air(float altitude_m, vec3 direction, float begin_m, float end_m, int steps) {
  AirMarch march = AirMarch(vec3(0.0), vec3(0.0), vec3(1.0));
  vec3 origin = vec3(0.0, 0.0, altitude_m);
  vec3 entry = origin + direction * begin_m;
  float length_m = max(0.0, end_m - begin_m);
  float mu = dot(vec3(entry.xy, entry.z + planet_radius_m), direction) / (planet_radius_m + altitude_m);
  float evenness = path_evenness(altitude_m, mu, length_m);
  float previous_m = 0.0;
  for (int i = 0; i < steps; ++i) {
    float next_m = length_m * path_share(float(i + 1) / float(steps), evenness);
    march = air_step(march, origin + direction * (begin_m + 0.5 * (previous_m + next_m)), direction, next_m - previous_m);
    previous_m = next_m;
  }
  return march;
}
#endif
