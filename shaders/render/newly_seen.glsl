// targets: rgba16f
// Puts what a moving picture sees for the first time, marched pixel by pixel, into the kept picture, and the discs of sun and moon where
// they shine: radiance; one sample / 64.
// With OUTLINES, of land, target 1: 1 / distance of what is seen (1/km).
#include "render/clouds_before.glsl"
#include "render/discs.glsl"
#include "lib/constants.glsl"
layout(binding = 0) uniform sampler2D scene_radiance;
layout(binding = 1) uniform sampler2D scene_depth;  // m; below 0: was not asked for, 0: in a tile that is not marked
layout(binding = 2) uniform sampler2D march_radiance;
layout(binding = 3) uniform sampler2D march_depth;

// tuned: a cloud that lets less of the sun through hides it, and is kept with less noise than one ray has.
const float least_shine = 1.0e-5;

#define PASS_LEAVES
bool leaves(ivec2 pixel) {
  float depth_m = texelFetch(scene_depth, pixel, 0).x;
  bool shines = depth_m >= no_hit_m && texelFetch(march_radiance, pixel, 0).w > least_shine;
  return depth_m < 0.0 || (in_disc(pixel) && !shines);
}

vec3 radiance_at(ivec2 pixel) {
  float sunlit = texelFetch(march_depth, pixel, 0).y;
  return clouds_before(texelFetch(scene_radiance, pixel, 0), texelFetch(march_radiance, pixel, 0), sunlit).xyz;
}

// The mean over what is newly seen about a pixel, but for land before or behind and beyond the edge of a disc: neighbours differ by where their steps begin, and all
// nine together have every beginning once (lib/hash.glsl).
vec3 mean_radiance(ivec2 pixel) {
  ivec2 last = textureSize(scene_depth, 0) - 1;
  float own_m = texelFetch(scene_depth, pixel, 0).x;
  vec4 sum = vec4(1.0e-3 * radiance_at(pixel), 1.0e-3);
  for (int i = 0; i < 9; ++i) {
    ivec2 at = clamp(pixel + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last);
    float behind_m = texelFetch(scene_depth, at, 0).x;
    bool same = behind_m > 0.0 && in_disc(at) == in_disc(pixel) && max(behind_m, own_m) <= 1.5 * min(behind_m, own_m);
    if (same) sum += vec4(radiance_at(at), 1.0);
  }
  return sum.xyz / sum.w;
}

PassOutput shade(ivec2 pixel) {
  vec4 kept = vec4(mean_radiance(pixel), 1.0 / 64.0);
#ifdef OUTLINES
  float opacity = 1.0 - texelFetch(march_radiance, pixel, 0).w;
  float distance_m = seen_at_m(opacity, texelFetch(march_depth, pixel, 0).x, texelFetch(scene_depth, pixel, 0).x);
  return PassOutput(kept, vec4(1000.0 / max(distance_m, 0.1)));
#else
  return PassOutput(kept);
#endif
}
