// targets: rgba8
// A picture with bloom as it is displayed.
#include "render/shown.glsl"
#include "lib/lens.glsl"
layout(binding = 0) uniform sampler2D radiance;
layout(binding = 1) uniform sampler2D glow;

PassOutput shade(ivec2 pixel) {
  vec2 middle = vec2(pixel) + 0.5;
  vec3 glows = texture(glow, middle / vec2(frame.size.xy)).xyz * lens_shows(frame.size.z, middle, vec2(frame.size.xy));
  return PassOutput(shown(texelFetch(radiance, pixel, 0).xyz + glows, pixel));
}
