// Which pixels of a moving picture show the disc of the sun or of the moon: too small and too bright for what is kept from frame to frame.
#ifndef RENDER_DISCS
#define RENDER_DISCS
#include "shared/resolve_block.glsl"

bool in_disc(ivec2 pixel) {
  vec2 from_sun = vec2(pixel) + 0.5 - resolve.sun.xy, from_moon = vec2(pixel) + 0.5 - resolve.moon.xy;
  return dot(from_sun, from_sun) < resolve.sun.z * resolve.sun.z || dot(from_moon, from_moon) < resolve.moon.z * resolve.moon.z;
}
#endif
