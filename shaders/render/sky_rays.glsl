// targets: rgba32f rgba32f
// The sky about the clouds and about the ground, by direction, for the table of light (render/sky_light.glsl): row 0 as the ground sees
// it, row 1 as the middle of the cloud layer does. Target 0: radiance of the air; target 1: transmittance to the ground, 0 for sky.
#include "shared/cloud_block.glsl"
#include "render/air_light.glsl"
#include "render/light_directions.glsl"

PassOutput shade(ivec2 pixel) {
  float altitude_m = pixel.y == 0 ? 0.0 : max(0.5 * (cloud.layer.x + cloud.layer.y), 1.0);
  vec3 direction = light_direction_of(pixel.x);
  vec3 origin = vec3(0.0, 0.0, altitude_m);
  vec2 planet = intersect_altitude(origin, direction, 0.0);
  bool to_ground = planet.x <= planet.y && planet.x > 0.0;
  vec2 air = intersect_altitude(origin, direction, atmosphere_top_m);
  AirMarch march = march_air(altitude_m, direction, max(air.x, 0.0), to_ground ? planet.x : air.y, 20);
  float phase = phase_cornette_shanks(dot(direction, frame.light_direction.xyz), frame.aerosol.x);
  return PassOutput(vec4(march.even + march.aerosol * phase, 1.0), vec4(to_ground ? march.transmittance : vec3(0.0), 1.0));
}
