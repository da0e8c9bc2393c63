// How a moving picture continues the one before it (server/render fills it). Binding 9.
#ifndef SHARED_RESOLVE_BLOCK
#define SHARED_RESOLVE_BLOCK
#include "shared/block.glsl"

/* kept: width, height of the kept picture, stride of its marched pixels, whether newly seen pixels are marched.
   marched: x, y of the marched pixel in its block, whether the picture moves, by how many kept pixels what is 1 km away moves before
   what does not.
   before_right, before_up, before_forward: axes of the camera before; before_right.w: tangent of half the height of its kept picture;
   before_up.w: width of that over its height; before_forward.w: whether there is a picture before.
   moved: from that camera to this one, m; moved.w: tangent of half the height of this kept picture. drift: of the clouds since, m; drift.w: how close (1/km)
   newly seen pixels are at most that are marched.
   sun, moon: column, row and radius of their discs in the kept picture, pixels; radius 0 where no rays are marched for them.
   trust: samples that a pixel's average holds at most, resting and moving; by how much of its range the neighbourhood is widened,
   resting and moving. */
#define RESOLVE_FIELDS(F) \
  F(ivec4, kept) \
  F(vec4, marched) \
  F(vec4, before_right) \
  F(vec4, before_up) \
  F(vec4, before_forward) \
  F(vec4, moved) \
  F(vec4, drift) \
  F(vec4, sun) \
  F(vec4, moon) \
  F(vec4, trust)
DECLARE_BLOCK(ResolveBlock, resolve, 9, RESOLVE_FIELDS)
#endif
