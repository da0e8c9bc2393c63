// The water of one frame (server/render fills it). Binding 8. Positions are relative to the point below the camera.
#ifndef SHARED_WATER_BLOCK
#define SHARED_WATER_BLOCK
#include "shared/block.glsl"

/* surface: altitude (m), mean square slope of what is in no train, 0, 1 / clarity (1/m).
   body: albedo, greatest slope of a train. view: width of a pixel of parallel rays (m), for each metre of distance, 0, 0.
   clouds: where the panorama of clouds was taken (east, north, m), altitude of the clouds above the water (m), its coarsest level (-1: there is none).
   waves_a to waves_f: from the longest to the shortest, four trains each (lib/water.glsl). */
#define WATER_FIELDS(F) \
  F(vec4, surface) \
  F(vec4, body) \
  F(vec4, clouds) \
  F(vec4, view) \
  F(mat4, waves_a) \
  F(mat4, waves_b) \
  F(mat4, waves_c) \
  F(mat4, waves_d) \
  F(mat4, waves_e) \
  F(mat4, waves_f)
DECLARE_BLOCK(WaterBlock, water, 8, WATER_FIELDS)
#endif
