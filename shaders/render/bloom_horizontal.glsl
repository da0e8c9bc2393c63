// targets: rgba32f
// The first half of a separable Gaussian: along the rows. Outside the picture there is no light, but for a panorama, which goes on
// at its other side.
#include "shared/bloom_block.glsl"
layout(binding = 0) uniform sampler2D bright;

float kernel(int distance) { return distance < 4 ? bloom.horizontal_near[distance] : bloom.horizontal_far[distance - 4]; }

vec3 light_at(int x, int y) {
  int width = bloom.size.x;
  // By floats: software divides integers one by one.
  int wrapped = bloom.size.z != 0 ? x - width * int(floor((float(x) + 0.5) / float(width))) : x;
  return wrapped < 0 || wrapped >= width ? vec3(0.0) : texelFetch(bright, ivec2(clamp(wrapped, 0, width - 1), y), 0).xyz;
}

PassOutput shade(ivec2 texel) {
  vec3 sum = kernel(0) * light_at(texel.x, texel.y);
  for (int i = 1; i <= bloom.size.w; ++i) sum += kernel(i) * (light_at(texel.x - i, texel.y) + light_at(texel.x + i, texel.y));
  return PassOutput(vec4(sum, 0.0));
}
