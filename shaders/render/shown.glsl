// Radiance to display values: exposure, tone curve, sRGB, dither (Olajos 2.7).
#ifndef RENDER_SHOWN
#define RENDER_SHOWN
#include "shared/frame_block.glsl"
#include "lib/display.glsl"
#include "lib/hash.glsl"

// Software computes both sides of every branch: whoever knows the curve says so.
#ifndef TONE_CURVE
#define TONE_CURVE int(frame.display.y)
#endif

// Triangular noise of one display step: hides the steps of 8 bits and adds no pattern of its own.
vec3 dither(ivec2 pixel) {
  uvec3 at = uvec3(uint(pixel.x), uint(pixel.y), 0u);
  return (hash_unit(at) - hash_unit(at + uvec3(0u, 0u, 1u))) / 255.0;
}

vec4 shown(vec3 radiance, ivec2 pixel) {
  vec3 value = display_from_radiance(radiance, frame.display.x, TONE_CURVE);
  if (frame.sample_info.w != 0) value += dither(pixel);
  return vec4(clamp(value, 0.0, 1.0), 1.0);
}
#endif
