// The frame's atmosphere, and sunlight (or moonlight) in it, from the table of transmittance.
#ifndef RENDER_AIR
#define RENDER_AIR
#include "shared/frame_block.glsl"
#include "lib/atmosphere.glsl"
#include "lib/sky_mapping.glsl"
layout(binding = 8) uniform sampler2D transmittance_table;

const vec2 transmittance_size = vec2(256.0, 64.0);
const vec2 multiple_size = vec2(32.0, 32.0);
const vec2 sky_view_size = vec2(48.0, 56.0);
const vec3 aerial_size = vec3(24.0, 32.0, 24.0);  // three blocks of it, one above the other
const vec2 cloud_sun_size = vec2(64.0, 16.0);
const float cloud_sun_span = 0.047;  // 300 km

Atmosphere frame_atmosphere() {
  return Atmosphere(frame.atmosphere.x, frame.atmosphere.y, frame.atmosphere.z, frame.atmosphere.w, frame.aerosol.x);
}
bool mirrored_sky() { return frame.sample_info.z < 2; }

// Along a direction that meets no planet.
vec3 space_transmittance(float altitude_m, float mu) {
  return textureLod(transmittance_table, table_uv(transmittance_uv(altitude_m, mu), transmittance_size), 0.0).xyz;
}

// Share of the light of a disc that arrives at an altitude where its middle stands at cosine `mu` to the vertical.
vec3 light_transmittance(float altitude_m, float mu, float radius) {
  return space_transmittance(altitude_m, mu) * disc_above_horizon(altitude_m, mu, radius);
}

// Parts of a direction along and across the azimuth of the light.
vec2 from_light_azimuth(vec2 direction) {
  vec2 light = frame.light_direction.xy;
  float size = length(light);
  light = size > 1.0e-5 ? light / size : vec2(0.0, 1.0);
  return vec2(dot(direction, light), light.x * direction.y - light.y * direction.x);
}
vec2 to_world_azimuth(vec2 along_across) {
  vec2 light = frame.light_direction.xy;
  float size = length(light);
  light = size > 1.0e-5 ? light / size : vec2(0.0, 1.0);
  return along_across.x * light + along_across.y * vec2(-light.y, light.x);
}
#endif
