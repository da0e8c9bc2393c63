// targets: rgba32f r32f
// Puts the clouds into the scene and adds the sample to the average of those before it. Target 0: radiance, 1 - transmittance of
// the clouds. Target 1: distance of what is seen, m.
#include "render/clouds_before.glsl"
#include "lib/constants.glsl"
layout(binding = 0) uniform sampler2D scene_radiance;
layout(binding = 1) uniform sampler2D scene_depth;
layout(binding = 2) uniform sampler2D march_radiance;
layout(binding = 3) uniform sampler2D march_depth;
layout(binding = 4) uniform sampler2D previous_radiance;
layout(binding = 5) uniform sampler2D previous_depth;

// Software computes both sides of every branch: whoever knows them says so.
#ifdef WHOLE_AND_ALONE  // the clouds of every pixel are marched, and nothing is averaged with them
#define MARCH_DIVISOR 1
#define SAMPLE_WEIGHT 1.0
#else
#define MARCH_DIVISOR frame.size.w
#define SAMPLE_WEIGHT frame.accumulation.x
#endif

PassOutput shade(ivec2 pixel) {
  ivec2 place = pixel + frame.march_target.xy;
  vec4 scene = texelFetch(scene_radiance, place, 0);
  float depth_m = texelFetch(scene_depth, place, 0).x;
  vec4 march;
  vec2 far;
  if (MARCH_DIVISOR == 1) {
    march = texelFetch(march_radiance, place, 0);
    far = texelFetch(march_depth, place, 0).xy;
  } else {
    vec2 uv = (vec2(pixel) + 0.5) / (float(frame.size.w) * vec2(textureSize(march_radiance, 0)));
    march = texture(march_radiance, uv);
    far = texelFetch(march_depth, ivec2(uv * vec2(textureSize(march_depth, 0))), 0).xy;
  }
  vec4 result = clouds_before(scene, march, far.y);
  float seen_m = seen_at_m(result.w, far.x, depth_m);
  float weight = SAMPLE_WEIGHT;
  if (weight < 1.0) {
    result = mix(texelFetch(previous_radiance, pixel, 0), result, weight);
    seen_m = mix(texelFetch(previous_depth, pixel, 0).x, seen_m, weight);
  }
  return PassOutput(result, vec4(seen_m));
}
