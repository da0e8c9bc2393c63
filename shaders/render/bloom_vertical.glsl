// targets: rgba32f
// The second half of a separable Gaussian: along the columns. Adds what the coarser levels have made, if there are any.
#include "shared/bloom_block.glsl"
layout(binding = 0) uniform sampler2D blurred_rows;
layout(binding = 1) uniform sampler2D scale;    // 1x1
layout(binding = 2) uniform sampler2D coarser;  // 1x1 and black where there is none

float kernel(int distance) { return distance < 4 ? bloom.vertical_near[distance] : bloom.vertical_far[distance - 4]; }

vec3 light_at(int x, int y) {
  int last = bloom.size.y - 1;
  return y < 0 || y > last ? vec3(0.0) : texelFetch(blurred_rows, ivec2(x, clamp(y, 0, last)), 0).xyz;
}

PassOutput shade(ivec2 texel) {
  vec3 sum = kernel(0) * light_at(texel.x, texel.y);
  for (int i = 1; i <= bloom.size.w; ++i) sum += kernel(i) * (light_at(texel.x, texel.y - i) + light_at(texel.x, texel.y + i));
  float share = bloom.gaussian.x * texelFetch(scale, ivec2(0), 0).x;
  vec3 wider = texture(coarser, (vec2(texel) + 0.5) / vec2(bloom.size.xy)).xyz;
  return PassOutput(vec4(share * sum + wider, 0.0));
}
