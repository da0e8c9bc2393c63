// targets: rgba8
// A kept picture as it is displayed: enlarged, with its glow.
#include "render/shown.glsl"
#include "shared/resolve_block.glsl"
layout(binding = 0) uniform sampler2D kept_radiance;
layout(binding = 1) uniform sampler2D glow;

PassOutput shade(ivec2 pixel) {
  vec2 place = ((vec2(pixel) + 0.5) / float(resolve.kept.w) + resolve.marched.zw) / vec2(resolve.kept.xy);
  vec3 radiance = textureLod(kept_radiance, place, 0.0).xyz + textureLod(glow, place, 0.0).xyz;
  return PassOutput(shown(radiance, pixel));
}
