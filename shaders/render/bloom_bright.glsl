// targets: rgba32f
// The finest level of the bloom's chain: mean of the radiance above the threshold.
#include "shared/frame_block.glsl"
#include "render/bloom_shrink.glsl"
layout(binding = 0) uniform sampler2D radiance;

PassOutput shade(ivec2 texel) {
  float threshold = frame.display.w / frame.display.x;
  Footprint area = footprint_of(texel, textureSize(radiance, 0));
  vec3 sum = vec3(0.0);
  for (int y = area.first.y; y < area.end.y; ++y) {
    float rows = pixel_overlap(y, area.low.y, area.high.y);
    for (int x = area.first.x; x < area.end.x; ++x) {
      float share = rows * pixel_overlap(x, area.low.x, area.high.x);
      sum += share * bloom_excess(texelFetch(radiance, ivec2(x, y), 0).xyz, threshold);
    }
  }
  return PassOutput(vec4(sum * area.per_area, 0.0));
}
