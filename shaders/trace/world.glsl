// The sun and the sky as paths meet them.
#ifndef TRACE_WORLD
#define TRACE_WORLD
#include "trace/surface.glsl"
#include "lib/sampling.glsl"

const float off_the_ground_m = 0.5;  // where rays from the ground begin, so that they do not meet it again at once

// On a plane normal to the beam, where nothing but the air is in the way.
vec3 sun_irradiance_at(vec3 p) {
  if (sky_kind() != sky_clear) return frame.sun_irradiance.xyz;
  return frame.sun_irradiance.xyz * space_transmittance(altitude_of(p), dot(up_at(p), frame.sun_direction.xyz));
}

// Evenly over the disc.
vec3 towards_sun(float u, float turn) { return sample_cap(frame.sun_direction.xyz, frame.sun_direction.w, u, turn); }

// By the chord: the cosine of a small angle has too few digits in 32 bits.
vec3 sun_disc_radiance(vec3 direction) {
  vec3 chord = direction - frame.sun_direction.xyz;
  if (dot(chord, chord) > frame.sun_direction.w) return vec3(0.0);
  return frame.sun_irradiance.w * sun_irradiance_at(vec3(0.0, 0.0, camera_altitude_m()));
}
#endif
