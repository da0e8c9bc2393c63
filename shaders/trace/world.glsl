// The sun and the sky as paths meet them.
#ifndef TRACE_WORLD
#define TRACE_WORLD
#include "trace/surface.glsl"
#include "render/sky_above.glsl"
#include "lib/sampling.glsl"

const float off_the_ground_m = 0.5;  // where rays from the ground begin, so that they do not meet it again at once

// From a point of the sun's disc: towards it, and the whole disc's irradiance on a plane normal to the beam.
struct Sunlight {
  vec3 direction, irradiance;
};

// Evenly over a disc; w: its radius.
vec3 towards_disc(vec4 middle, float u, float turn) {
  float chord = 2.0 * sin(0.5 * middle.w);
  return sample_cap(middle.xyz, chord * chord, u, turn);
}
#endif
