// The sky that a view ray ends in: the air's light, the sun's and the moon's disc, stars.
#ifndef RENDER_SKY_ABOVE
#define RENDER_SKY_ABOVE
#include "render/sky.glsl"
#include "lib/stars.glsl"
#include "lib/sun_disc.glsl"
layout(binding = 9) uniform sampler2D sky_view_table;
layout(binding = 7) uniform sampler2D sky_view_aerosol_table;

vec3 sky_radiance(vec3 direction) {
  if (sky_kind() != sky_clear) return sky_kind() == sky_uniform ? frame.sky.xyz : vec3(0.0);
  vec2 azimuth = from_light_azimuth(direction.xy);
  vec2 uv = table_uv(vec2(azimuth_coordinate(azimuth.x, azimuth.y, mirrored_sky()),
                          sky_view_v(direction.z, horizon_sine(camera_altitude_m()))), sky_view_size);
  float phase = phase_cornette_shanks(dot(direction, frame.light_direction.xyz), frame.aerosol.x);
  return textureLod(sky_view_table, uv, 0.0).xyz + phase * textureLod(sky_view_aerosol_table, uv, 0.0).xyz;
}

// By the chord: the cosine of a small angle has too few digits in 32 bits.
vec3 sun_disc(vec3 direction) {
  vec3 chord = direction - frame.sun_direction.xyz;
  float share = dot(chord, chord) / frame.sun_direction.w;
  if (share > 1.0 || frame.sun_irradiance.w <= 0.0) return vec3(0.0);
  return frame.sun_irradiance.xyz * frame.sun_irradiance.w * limb_darkening(sqrt(share));
}

// Full moons have no limb darkening: the lit part is as bright everywhere, and goes over into the shadow within a few degrees. tuned:
// that, and the earth's light on the rest.
vec4 moon_disc(vec3 direction) {
  vec3 chord = direction - frame.moon_direction.xyz;
  float share = dot(chord, chord) / max(frame.moon_direction.w, 1.0e-12);
  if (share > 1.0 || frame.moon_direction.w <= 0.0) return vec4(0.0);
  vec3 out_of_disc = chord / sqrt(frame.moon_direction.w);
  vec3 normal = normalize(out_of_disc - sqrt(1.0 - share) * frame.moon_direction.xyz);
  float lit = smoothstep(-0.03, 0.12, dot(normal, frame.moon_lit_from.xyz));
  return vec4(frame.moon_radiance.xyz * mix(2.0e-4, 1.0, lit), 1.0);
}

vec3 stars(vec3 direction) {
  vec3 on_sphere = vec3(dot(direction, frame.star_x.xyz), dot(direction, frame.star_y.xyz), dot(direction, frame.star_z.xyz));
  vec3 sum = vec3(0.0);
  for (int layer = 0; layer < frame.sample_info.y; ++layer) {
    // Each layer's cells lie across those of the other.
    vec3 turned = layer == 0 ? on_sphere : vec3(0.6 * on_sphere.x + 0.8 * on_sphere.z, on_sphere.y, 0.6 * on_sphere.z - 0.8 * on_sphere.x);
    sum += star_radiance(turned, uint(layer), frame.star_x.w);
  }
  return sum * frame.stars.xyz;
}

// Of what lies beyond the air, unattenuated.
vec3 radiance_of_space(vec3 direction) {
  vec4 moon = moon_disc(direction);
  return sun_disc(direction) + mix(stars(direction) + frame.night.xyz, moon.xyz, moon.w);
}

vec3 radiance_above(vec3 direction) {
  vec3 sky = sky_radiance(direction);
  vec3 beyond = radiance_of_space(direction);
  vec3 through = vec3(1.0);
  if (sky_kind() == sky_clear) through = space_transmittance(camera_altitude_m(), direction.z);
  return sky + beyond * through;
}
#endif
