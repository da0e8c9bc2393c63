// targets: rgba16f
// Table of the clear sky's radiance as the camera sees it: single scattering by air and aerosol, and an even share of light
// scattered more often. Below the horizon: the air in front of the ground.
#include "shared/frame_block.glsl"
#include "lib/atmosphere.glsl"
#include "lib/phase.glsl"
#include "lib/sky_mapping.glsl"
layout(binding = 8) uniform sampler2D transmittance_table;

const int march_steps = 28;  // tuned: more changes no channel by a display step

vec3 sun_transmittance(vec3 position) {
  vec3 up = vec3(position.xy, position.z + planet_radius_m);
  float r = length(up);
  float mu = dot(up, frame.sun_direction.xyz) / r;
  vec2 uv = table_uv(transmittance_uv(r - planet_radius_m, mu), vec2(64.0));
  return texture(transmittance_table, uv).xyz;
}

// Light scattered more than once, as a share of the sunlight at the point, by wavelength. tuned: stands for a transport solution
// within a fifth of the sky's radiance at noon; a table of it comes with the physical atmosphere.
vec3 multiple_scattering_share() { return vec3(0.25, 0.45, 0.80) + frame.ground_albedo.xyz * max(frame.sun_direction.z, 0.0); }

PassOutput shade(ivec2 pixel) {
  float altitude_m = max(frame.camera_forward.w, 1.0);
  vec2 angles = sky_view_angles(table_parameter(vec2(pixel), vec2(96.0, 96.0)), horizon_dip(altitude_m));
  vec2 sun_horizontal = length(frame.sun_direction.xy) > 1.0e-5 ? normalize(frame.sun_direction.xy) : vec2(0.0, 1.0);
  vec2 side = vec2(-sun_horizontal.y, sun_horizontal.x);
  vec3 direction = vec3(cos(angles.x) * (cos(angles.y) * sun_horizontal + sin(angles.y) * side), sin(angles.x));
  vec3 origin = vec3(0.0, 0.0, altitude_m);
  vec2 ground = intersect_altitude(origin, direction, 0.0);
  bool to_ground = ground.x <= ground.y && ground.x > 0.0;
  float end_m = to_ground ? ground.x : max(0.0, intersect_altitude(origin, direction, atmosphere_top_m).y);
  float cos_theta = dot(direction, frame.sun_direction.xyz);
  float rayleigh_phase = phase_rayleigh(cos_theta);
  float aerosol_phase = phase_cornette_shanks(cos_theta, aerosol_asymmetry_g);
  vec3 radiance = vec3(0.0);
  vec3 transmittance = vec3(1.0);
  float previous_m = 0.0;
  for (int i = 0; i < march_steps; ++i) {
    float x = float(i + 1) / float(march_steps);
    float next_m = end_m * (to_ground ? x : x * x);
    float step_m = next_m - previous_m;
    vec3 p = origin + direction * (0.5 * (previous_m + next_m));
    float h = length(vec3(p.xy, p.z + planet_radius_m)) - planet_radius_m;
    vec3 air = rayleigh_scattering_per_m() * rayleigh_density(h);
    float aerosol = frame.atmosphere.x * aerosol_scattering_per_m() * aerosol_density(h);
    vec3 sun = sun_transmittance(p);
    vec3 source = sun * (air * rayleigh_phase + aerosol * aerosol_phase) +
                  sun * (air + aerosol) * phase_isotropic * multiple_scattering_share();
    vec3 step_transmittance = exp(-atmosphere_extinction_per_m(h, frame.atmosphere.x) * step_m);
    vec3 extinction = max(atmosphere_extinction_per_m(h, frame.atmosphere.x), vec3(1.0e-9));
    radiance += transmittance * source * (1.0 - step_transmittance) / extinction;
    transmittance *= step_transmittance;
    previous_m = next_m;
  }
  return PassOutput(vec4(radiance * frame.sun_irradiance.xyz, 1.0));
}
