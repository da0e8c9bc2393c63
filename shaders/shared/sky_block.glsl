// What the passes that bake the sky tables need beside the frame (server/render fills it). Binding 5.
#ifndef SHARED_SKY_BLOCK
#define SHARED_SKY_BLOCK
#include "shared/block.glsl"

/* level: altitude of the camera that is baked for (m), share of the upper level in a blend, whether it is the first order, 0. */
#define SKY_FIELDS(F) F(vec4, level)
DECLARE_BLOCK(SkyBlock, sky, 5, SKY_FIELDS)
#endif
