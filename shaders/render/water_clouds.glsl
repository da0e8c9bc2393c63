// targets: rgba32f
// The clouds that water reflects: the upper half of a panorama of them, from its march. Averaged as in render/smooth.glsl.
#include "shared/frame_block.glsl"
layout(binding = 0) uniform sampler2D march_radiance;

PassOutput shade(ivec2 pixel) {
  vec4 sum = vec4(0.0);
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      sum += texelFetch(march_radiance, ivec2((pixel.x + x + frame.size.x) % frame.size.x,
                                              clamp(pixel.y + y, 0, frame.size.y / 2 - 1)), 0);
  return PassOutput(vec4(sum.xyz / frame.accumulation.z, sum.w) / 9.0);
}
