// What the path tracer's dispatches need (server/render fills it). Binding 6.
#ifndef SHARED_TRACE_BLOCK
#define SHARED_TRACE_BLOCK
#include "shared/block.glsl"

/* work: first and number of the entries in the list of slots, number of pixels, number of the sample that none may begin.
   limits: greatest scattering order (0: none), rounds of a dispatch, flights of a round, number of slots.
   seed: seed, first sample of a pixel, 0, 0. cells: of the fine grid of majorants; fine cells to an edge of a coarse one.
   slopes: how far the variation of the land shifts the tile east and north (tiles a metre), how much it changes the threshold (a
   metre), how much faster altitudes can change than at the point (heights of the layer a metre). */
#define TRACE_FIELDS(F) \
  F(ivec4, work) \
  F(ivec4, limits) \
  F(uvec4, seed) \
  F(ivec4, cells) \
  F(vec4, slopes)
DECLARE_BLOCK(TraceBlock, trace, 6, TRACE_FIELDS)
#endif
