// targets: rgba32f
// The next coarser level of the bloom's chain.
#include "render/bloom_shrink.glsl"
layout(binding = 0) uniform sampler2D finer;

PassOutput shade(ivec2 texel) {
  Footprint area = footprint_of(texel, textureSize(finer, 0));
  vec3 sum = vec3(0.0);
  for (int y = area.first.y; y < area.end.y; ++y) {
    float rows = pixel_overlap(y, area.low.y, area.high.y);
    for (int x = area.first.x; x < area.end.x; ++x)
      sum += rows * pixel_overlap(x, area.low.x, area.high.x) * texelFetch(finer, ivec2(x, y), 0).xyz;
  }
  return PassOutput(vec4(sum * area.per_area, 0.0));
}
