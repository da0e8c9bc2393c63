// targets: rgba16f
// What a frame marched, evened where all that is seen lies within some steps, as from within a cloud: neighbours differ there by where
// their steps begin more than by what they see, and all nine together have every beginning once (lib/hash.glsl). Radiance; 1 / distance
// of what is seen (1/km), below 0 of land, water and sky.
#include "shared/resolve_block.glsl"
#include "render/small_step.glsl"
layout(binding = 0) uniform sampler2D marched_radiance;
layout(binding = 1) uniform sampler2D marched_depth;

float closeness_per_km(float distance_m) { return 1000.0 / max(distance_m, 0.1); }
float signed_closeness(float closeness, float cloud) { return cloud < 0.5 ? -closeness : closeness; }  // as composite.glsl has it

PassOutput shade(ivec2 pixel) {
  ivec2 last = textureSize(marched_radiance, 0) - 1;
  float own_m = texelFetch(marched_depth, pixel, 0).x;
  vec4 radiance_opacity = texelFetch(marched_radiance, pixel, 0);
  vec4 own = vec4(radiance_opacity.xyz, closeness_per_km(own_m));
  vec4 sum = vec4(0.0);
  float summed = 0.0;
  for (int i = 0; i < 9; ++i) {
    ivec2 at = clamp(pixel + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last);
    float distance_m = texelFetch(marched_depth, at, 0).x;
    float counts = distance_m <= 2.0 * own_m ? 1.0 : 0.0;  // not what lies behind
    sum += counts * vec4(texelFetch(marched_radiance, at, 0).xyz, closeness_per_km(distance_m));
    summed += counts;
  }
  // tuned: the more steps, the more is gone of what the rays did see.
  float in_cloud = smoothstep(0.5, 1.0, radiance_opacity.w);  // and not before land
  float share = resolve.marched.z * in_cloud * (1.0 - smoothstep(4.0, 8.0, own_m / small_step_m(own_m)));
  vec4 evened = mix(own, sum / max(summed, 1.0), share);
  return PassOutput(vec4(evened.xyz, signed_closeness(evened.w, radiance_opacity.w)));
}
