// Which pixels a pass is asked for: all, or those that a moving picture sees for the first time or shows the sun or the moon in.
#ifndef RENDER_ASKED_PIXELS
#define RENDER_ASKED_PIXELS
#include "shared/frame_block.glsl"
#include "render/discs.glsl"
layout(binding = 16) uniform sampler2D kept_picture;  // radiance, samples in the average / 64: none where nothing was kept

bool asked_for(ivec2 pixel) {
  int newly = frame.march_target.z;
  return newly == 0 || texelFetch(kept_picture, pixel * newly, 0).w <= 0.0 || in_disc(pixel);
}
#endif
