// Reading the sky tables: sky radiance, light that arrives, and what the air does between the camera and a point.
#ifndef RENDER_SKY
#define RENDER_SKY
#include "render/air.glsl"
#include "lib/phase.glsl"
layout(binding = 10) uniform sampler2D light_table;
layout(binding = 14) uniform sampler3D aerial_table;

const int sky_none = 0;
const int sky_uniform = 1;
const int sky_clear = 2;
#ifndef SKY_KIND
#define SKY_KIND int(frame.sky.w)
#endif
int sky_kind() { return SKY_KIND; }
float camera_altitude_m() { return frame.camera_forward.w; }

// Entries of the light table (render/sky_light.glsl).
vec3 sky_irradiance() { return texelFetch(light_table, ivec2(0, 0), 0).xyz; }
vec3 ground_radiance() { return texelFetch(light_table, ivec2(1, 0), 0).xyz; }
vec3 surroundings(int part) { return texelFetch(light_table, ivec2(2 + part, 0), 0).xyz; }

// Irradiance by the sun (or the moon) on a plane normal to its beam.
vec3 light_at(float altitude_m, float mu) {
  vec3 arrives = sky_kind() == sky_clear ? light_transmittance(altitude_m, mu, frame.light_direction.w) : vec3(1.0);
  return frame.light_irradiance.xyz * arrives;
}

struct Air {
  vec3 transmittance;
  vec3 in_scatter;
};

// Where a direction lies in the blocks of the aerial table, and the row of a distance in the first of them.
vec2 aerial_uv(vec3 direction) {
  vec2 azimuth = from_light_azimuth(direction.xy);
  float u = azimuth_coordinate(azimuth.x, azimuth.y, mirrored_sky());
  return table_uv(vec2(u, aerial_v(direction.z, horizon_sine(camera_altitude_m()))), aerial_size.xy);
}
float aerial_row(float distance_m) {
  return (0.5 + aerial_w(max(distance_m, 0.0)) * (aerial_size.z - 1.0)) / (3.0 * aerial_size.z);
}

// The air between the camera and a point.
Air air_to(vec3 direction, float distance_m) {
  if (sky_kind() != sky_clear) return Air(vec3(1.0), vec3(0.0));
  float begin_m = aerial_begin_m(camera_altitude_m(), direction);
  vec2 uv = aerial_uv(direction);
  float row = aerial_row(distance_m - begin_m);
  vec3 even = textureLod(aerial_table, vec3(uv, row), 0.0).xyz;
  vec3 aerosol = textureLod(aerial_table, vec3(uv, row + 1.0 / 3.0), 0.0).xyz;
  vec3 transmittance = textureLod(aerial_table, vec3(uv, row + 2.0 / 3.0), 0.0).xyz;
  float phase = phase_cornette_shanks(dot(direction, frame.light_direction.xyz), frame.aerosol.x);
  return Air(transmittance, even + aerosol * phase);
}
#endif
