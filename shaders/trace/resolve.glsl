// targets: rgba32f r32f rgba32f
// The sums of a path-traced picture as a picture. Target 0: mean radiance, share of the samples that met the medium first. Target 1:
// mean distance of what most of them met, m; no_hit_m for sky. Target 2: standard error of the mean radiance (0 of a single sample).
#include "shared/trace_block.glsl"
#include "lib/constants.glsl"
layout(binding = 0) uniform sampler2D sums;
layout(binding = 1) uniform sampler2D lost;
layout(binding = 2) uniform sampler2D squares;
layout(binding = 3) uniform sampler2D lost_squares;

PassOutput shade(ivec2 pixel) {
  float samples = float(trace.work.w);
  vec4 sum = texelFetch(sums, pixel, 0);
  vec4 rest = texelFetch(lost, pixel, 0);
  vec4 square = texelFetch(squares, pixel, 0);
  vec4 square_rest = texelFetch(lost_squares, pixel, 0);
  vec3 mean = (sum.xyz - rest.xyz) / samples;
  vec3 variance = max(vec3(0.0), (square.xyz - square_rest.xyz) / samples - mean * mean) * samples / max(samples - 1.0, 1.0);
  vec3 standard_error = samples > 1.0 ? sqrt(variance / samples) : vec3(0.0);
  float seen_m = no_hit_m;
  if (sum.w >= 0.5 * samples) seen_m = rest.w / sum.w;
  else if (square_rest.w >= 0.5 * (samples - sum.w)) seen_m = square.w / square_rest.w;
  return PassOutput(vec4(mean, sum.w / samples), vec4(seen_m), vec4(standard_error, 0.0));
}
