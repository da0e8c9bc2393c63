// targets: rgba32f
// Table of the light in the air that was scattered before, its mean over all directions, per unit of irradiance (Hillaire 2020, section
// 5.5). The first pass closes the series of orders as Hillaire does, with one and the same share f of each order in the next:
// 1 / (1 - f). Each later pass replaces that by one more true order: it gathers the light of the table before it along every
// direction. The first order is gathered with its phase functions, all later ones as if they scattered evenly.
#include "render/air.glsl"
#include "shared/sky_block.glsl"
#include "lib/phase.glsl"
layout(binding = 9) uniform sampler2D multiple_table;

const int gather_elevations = 12;  // tuned, all three: twice as many change no channel of the sky by a hundredth
const int gather_azimuths = 4;     // of the half sky on one side of the sun
const int gather_steps = 16;

vec3 scattered_before(float altitude_m, float mu) {
  if (sky.level.z != 0.0) return vec3(0.0);
  return textureLod(multiple_table, table_uv(multiple_uv(altitude_m, mu), multiple_size), 0.0).xyz;
}

// Radiance of sunlit ground. The sky's light on it is what the table has at the ground: the mean of the sky above and of the ground.
vec3 ground_radiance_at(float mu) {
  vec3 albedo = frame.ground.x > 0.0 ? frame.ground_albedo.xyz : vec3(0.0);
  vec3 direct = light_transmittance(0.0, mu, frame.light_direction.w) * max(mu, 0.0);
  return albedo * (direct / pi + 2.0 * scattered_before(0.0, mu)) / (1.0 + albedo);
}

struct Gathered {
  vec3 radiance, share;
};

Gathered gather(float altitude_m, vec3 direction, vec3 sun) {
  vec3 origin = vec3(0.0, 0.0, altitude_m);
  vec2 planet = intersect_altitude(origin, direction, 0.0);
  bool to_ground = planet.x <= planet.y && planet.x > 0.0;
  float length_m = to_ground ? planet.x : max(0.0, intersect_altitude(origin, direction, atmosphere_top_m).y);
  float evenness = to_ground ? 1.0 : path_evenness(altitude_m, direction.z, length_m);
  float rayleigh_phase = phase_rayleigh(dot(direction, sun));
  float aerosol_phase = phase_cornette_shanks(dot(direction, sun), frame.aerosol.x);
  Gathered sum = Gathered(vec3(0.0), vec3(0.0));
  vec3 transmittance = vec3(1.0);
  float previous_m = 0.0;
  for (int i = 0; i < gather_steps; ++i) {
    float next_m = length_m * path_share(float(i + 1) / float(gather_steps), evenness);
    vec3 p = origin + direction * (0.5 * (previous_m + next_m));
    float h = max(altitude_far_of(p), 0.0);
    float mu = dot(vec3(p.xy, p.z + planet_radius_m), sun) / (h + planet_radius_m);
    AirAt air = air_at(h, frame_atmosphere());
    vec3 scattering = air.rayleigh + vec3(air.aerosol);
    vec3 source = (air.rayleigh * rayleigh_phase + vec3(air.aerosol * aerosol_phase)) *
                      light_transmittance(h, mu, frame.light_direction.w) + scattering * scattered_before(h, mu);
    vec3 step_transmittance = exp(-air.extinction * (next_m - previous_m));
    vec3 path = transmittance * (1.0 - step_transmittance) / max(air.extinction, vec3(1.0e-12));
    sum.radiance += path * source;
    sum.share += path * scattering;
    transmittance *= step_transmittance;
    previous_m = next_m;
  }
  if (to_ground) {
    vec3 p = origin + direction * length_m;
    sum.radiance += transmittance * ground_radiance_at(dot(vec3(p.xy, p.z + planet_radius_m), sun) / planet_radius_m);
  }
  return sum;
}

PassOutput shade(ivec2 pixel) {
  vec2 parameter = table_parameter(vec2(pixel), multiple_size);
  float altitude_m = max(multiple_altitude_m(parameter.y), 1.0);
  float mu = multiple_mu(parameter.x);
  vec3 sun = vec3(sqrt(max(0.0, 1.0 - mu * mu)), 0.0, mu);
  Gathered sum = Gathered(vec3(0.0), vec3(0.0));
  for (int i = 0; i < gather_elevations; ++i) {
    float s = (2.0 * float(i) + 1.0) / float(gather_elevations) - 1.0;
    float z = s * abs(s);  // fine about the horizon
    for (int k = 0; k < gather_azimuths; ++k) {
      float azimuth = pi * (float(k) + 0.5) / float(gather_azimuths);
      float horizontal = sqrt(1.0 - z * z);
      Gathered one = gather(altitude_m, vec3(horizontal * cos(azimuth), horizontal * sin(azimuth), z), sun);
      float weight = 2.0 * abs(s) / float(gather_elevations * gather_azimuths);
      sum.radiance += weight * one.radiance;
      sum.share += weight * one.share;
    }
  }
  if (sky.level.z != 0.0) sum.radiance /= max(1.0 - sum.share, vec3(0.05));
  return PassOutput(vec4(sum.radiance, 1.0));
}
