// targets: rgba8
// Radiance to display values: exposure, tone curve, sRGB, dither (Olajos 2.7).
#include "shared/frame_block.glsl"
#include "lib/display.glsl"
#include "lib/hash.glsl"
layout(binding = 0) uniform sampler2D radiance;

// Triangular noise of one display step: hides the steps of 8 bits and adds no pattern of its own.
vec3 dither(ivec2 pixel) {
  uvec3 at = uvec3(uint(pixel.x), uint(pixel.y), 0u);
  return (hash_unit(at) - hash_unit(at + uvec3(0u, 0u, 1u))) / 255.0;
}

PassOutput shade(ivec2 pixel) {
  vec3 value = display_from_radiance(texelFetch(radiance, pixel, 0).xyz, frame.display.x, int(frame.display.y));
  if (frame.sample_info.w != 0) value += dither(pixel);
  return PassOutput(vec4(clamp(value, 0.0, 1.0), 1.0));
}
