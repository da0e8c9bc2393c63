// targets: r32f
// One texel: what all the glowing light is multiplied with. Reads the coarsest level of the chain, a few hundred texels.
#include "shared/frame_block.glsl"
#include "lib/bloom.glsl"
layout(binding = 0) uniform sampler2D coarsest;

PassOutput shade(ivec2 texel) {
  ivec2 size = textureSize(coarsest, 0);
  float sum = 0.0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) sum += luminance(texelFetch(coarsest, ivec2(x, y), 0).xyz);
  float mean = sum / float(size.x * size.y);
  float picture_area = float(frame.size.x) / float(frame.size.y);
  return PassOutput(vec4(frame.display.z * bloom_scale(frame.display.x * mean * picture_area)));
}
