// targets: rgba16f
// Puts what a moving picture sees for the first time, marched pixel by pixel, into the kept picture: radiance; one sample / 64.
// With OUTLINES, of land, target 1: 1 / distance of what is seen (1/km).
#include "render/clouds_before.glsl"
layout(binding = 0) uniform sampler2D scene_radiance;
layout(binding = 1) uniform sampler2D scene_depth;  // below 0: was not asked for
layout(binding = 2) uniform sampler2D march_radiance;
layout(binding = 3) uniform sampler2D march_depth;

#define PASS_LEAVES
bool leaves(ivec2 pixel) { return texelFetch(scene_depth, pixel, 0).x < 0.0; }

PassOutput shade(ivec2 pixel) {
  vec2 far = texelFetch(march_depth, pixel, 0).xy;
  vec4 seen = clouds_before(texelFetch(scene_radiance, pixel, 0), texelFetch(march_radiance, pixel, 0), far.y);
  vec4 kept = vec4(seen.xyz, 1.0 / 64.0);
#ifdef OUTLINES
  float distance_m = seen_at_m(seen.w, far.x, texelFetch(scene_depth, pixel, 0).x);
  return PassOutput(kept, vec4(1000.0 / max(distance_m, 0.1)));
#else
  return PassOutput(kept);
#endif
}
