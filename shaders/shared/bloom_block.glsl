// One level of the bloom's chain and the Gaussian that it is blurred with (server/render fills it). Binding 4.
#ifndef SHARED_BLOOM_BLOCK
#define SHARED_BLOOM_BLOCK
#include "shared/block.glsl"

/* size: width and height of the level (texels), whether left and right of the picture meet, texels of the kernel on each side.
   gaussian: share of the glow, 0, 0, 0. horizontal_near/far, vertical_near/far: the kernel's weights at 0..3 and 4..7 texels. */
#define BLOOM_FIELDS(F) \
  F(ivec4, size) \
  F(vec4, gaussian) \
  F(vec4, horizontal_near) \
  F(vec4, horizontal_far) \
  F(vec4, vertical_near) \
  F(vec4, vertical_far)
DECLARE_BLOCK(BloomBlock, bloom, 4, BLOOM_FIELDS)
#endif
