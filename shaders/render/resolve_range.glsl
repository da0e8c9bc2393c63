// targets: rgba16f rgba16f
// Of each marched pixel and its eight neighbours: the least radiance, 1 / the least distance of what is seen (1/km); the greatest radiance.
#include "shared/resolve_block.glsl"
layout(binding = 0) uniform sampler2D marched_radiance;
layout(binding = 1) uniform sampler2D marched_depth;

PassOutput shade(ivec2 pixel) {
  ivec2 last = textureSize(marched_radiance, 0) - 1;
  vec3 least = texelFetch(marched_radiance, pixel, 0).xyz;
  vec3 greatest = least;
  float nearest_m = resolve.drift.w;
  for (int i = 0; i < 9; ++i) {
    ivec2 at = clamp(pixel + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last);
    vec3 radiance = texelFetch(marched_radiance, at, 0).xyz;
    least = min(least, radiance);
    greatest = max(greatest, radiance);
    nearest_m = min(nearest_m, texelFetch(marched_depth, at, 0).x);
  }
  return PassOutput(vec4(least, 1000.0 / max(nearest_m, 0.1)), vec4(greatest, 0.0));
}
