// The sun and the sky as paths meet them.
#ifndef TRACE_WORLD
#define TRACE_WORLD
#include "trace/surface.glsl"
#include "render/sky_above.glsl"
#include "lib/sampling.glsl"

const float off_the_ground_m = 0.5;  // where rays from the ground begin, so that they do not meet it again at once

// By the sun, or at night the moon, on a plane normal to the beam, where nothing but the air is in the way.
vec3 sun_irradiance_at(vec3 p) {
  return light_at(altitude_of(p), dot(up_at(p), frame.light_direction.xyz));
}

// Evenly over the disc.
vec3 towards_sun(float u, float turn) {
  float chord = 2.0 * sin(0.5 * frame.light_direction.w);
  return sample_cap(frame.light_direction.xyz, chord * chord, u, turn);
}

// What a path that leaves the world ends in; the discs are for the camera alone, for the sun has been looked for at every turn.
vec3 radiance_beyond(vec3 direction, bool first) {
  vec2 planet = intersect_altitude(vec3(0.0, 0.0, camera_altitude_m()), direction, 0.0);
  if (sky_kind() == sky_clear && planet.x <= planet.y && planet.y > 0.0) return air_to(direction, max(planet.x, 0.0)).in_scatter;
  return first ? radiance_above(direction) : sky_radiance(direction);
}
#endif
