// targets: rgba8
// A kept picture in display values, with its glow.
#include "render/shown.glsl"
layout(binding = 0) uniform sampler2D kept_radiance;
layout(binding = 1) uniform sampler2D glow;

PassOutput shade(ivec2 pixel) {
  vec2 place = (vec2(pixel) + 0.5) / vec2(textureSize(kept_radiance, 0));
  return PassOutput(shown(texelFetch(kept_radiance, pixel, 0).xyz + textureLod(glow, place, 0.0).xyz, pixel));
}
