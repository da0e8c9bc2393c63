// Reading the sky tables: sky radiance, sunlight that arrives, and what the air does between the camera and a point.
#ifndef RENDER_SKY
#define RENDER_SKY
#include "shared/frame_block.glsl"
#include "lib/atmosphere.glsl"
#include "lib/sky_mapping.glsl"
layout(binding = 8) uniform sampler2D transmittance_table;
layout(binding = 9) uniform sampler2D sky_view_table;
layout(binding = 10) uniform sampler2D light_table;

const int sky_none = 0;
const int sky_uniform = 1;
const int sky_clear = 2;
int sky_kind() { return int(frame.sky.w); }
float camera_altitude_m() { return frame.camera_forward.w; }

// Rows of the light table (render/sky_light.glsl), rgb.
vec3 sky_mean_radiance() { return texelFetch(light_table, ivec2(0, 0), 0).xyz; }
vec3 sky_irradiance() { return texelFetch(light_table, ivec2(1, 0), 0).xyz; }
vec3 sun_irradiance_at_bottom() { return texelFetch(light_table, ivec2(2, 0), 0).xyz; }
vec3 sun_irradiance_at_top() { return texelFetch(light_table, ivec2(3, 0), 0).xyz; }
vec3 sun_irradiance_at_ground() { return texelFetch(light_table, ivec2(4, 0), 0).xyz; }
vec3 ground_radiance() { return texelFetch(light_table, ivec2(5, 0), 0).xyz; }

vec3 space_transmittance(float altitude_m, float mu) {
  return texture(transmittance_table, table_uv(transmittance_uv(altitude_m, mu), vec2(64.0))).xyz;
}

vec3 sky_view_radiance(vec3 direction) {
  float horizontal = sqrt(max(1.0e-8, 1.0 - direction.z * direction.z));
  float sun_horizontal = sqrt(max(1.0e-8, 1.0 - frame.sun_direction.z * frame.sun_direction.z));
  float cos_azimuth = dot(direction.xy, frame.sun_direction.xy) / (horizontal * sun_horizontal);
  vec2 uv = sky_view_uv(asin(clamp(direction.z, -1.0, 1.0)), cos_azimuth, horizon_dip(camera_altitude_m()));
  return texture(sky_view_table, table_uv(uv, vec2(96.0, 96.0))).xyz;
}

vec3 sky_radiance(vec3 direction) {
  if (sky_kind() == sky_clear) return sky_view_radiance(direction);
  return sky_kind() == sky_uniform ? frame.sky.xyz : vec3(0.0);
}

struct Air {
  vec3 transmittance;
  vec3 in_scatter;
};

// The air between the camera and a point `distance_m` away at `altitude_m`. The table holds the light scattered in along the
// whole ray; of it the part up to the point is taken in proportion to the light lost, which is exact where the air is lit evenly.
Air air_to(vec3 direction, float distance_m, float altitude_m) {
  if (sky_kind() != sky_clear) return Air(vec3(1.0), vec3(0.0));
  vec3 near = exp(-air_optical_depth(camera_altitude_m(), altitude_m, distance_m, frame.atmosphere.x));
  vec3 whole = space_transmittance(camera_altitude_m(), direction.z);
  vec2 ground = intersect_altitude(vec3(0.0, 0.0, camera_altitude_m()), direction, 0.0);
  if (ground.x <= ground.y && ground.x > 0.0)
    whole = exp(-air_optical_depth(camera_altitude_m(), 0.0, ground.x, frame.atmosphere.x));
  vec3 share = clamp((1.0 - near) / max(1.0 - whole, vec3(1.0e-4)), 0.0, 1.0);
  return Air(near, share * sky_view_radiance(direction));
}
#endif
