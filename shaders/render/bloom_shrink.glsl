// Reads a finer picture so that each texel is the mean of its footprint there, whatever the ratio of the sizes: no light is lost.
#ifndef RENDER_BLOOM_SHRINK
#define RENDER_BLOOM_SHRINK
#include "shared/bloom_block.glsl"
#include "lib/bloom.glsl"

struct Footprint {
  vec2 low, high;  // in pixels of the finer picture
  ivec2 first, end;
  float per_area;
};

Footprint footprint_of(ivec2 texel, ivec2 finer_size) {
  vec2 ratio = vec2(finer_size) / vec2(bloom.size.xy);
  vec2 low = vec2(texel) * ratio;
  vec2 high = low + ratio;
  // A rounding error beyond the edge of a pixel is not worth a row of reads.
  ivec2 end = min(ivec2(ceil(high - 1.0e-3)), finer_size);
  return Footprint(low, high, ivec2(low + 1.0e-3), end, 1.0 / (ratio.x * ratio.y));
}
#endif
