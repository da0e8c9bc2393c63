// The terrain of one frame (server/render fills it). Binding 3. Positions are relative to the point below the camera.
#ifndef SHARED_TERRAIN_BLOCK
#define SHARED_TERRAIN_BLOCK
#include "shared/block.glsl"

/* lattice: points per metre, metres per point, lattice coordinates east and north of the point below the camera.
   size: points a side, coarsest level, tiling?, 0. box: west, south, east, north edge (m) of a single map.
   altitude: base, highest, lowest (m), width of a pixel for each metre of distance. cover: snow line, tree line (m), tangent of
   the slope from which rock is bare, 0. sun: unit vector towards its azimuth (east, north), half the width of a shadow's edge
   (radians), width of a pixel of parallel rays (m). rock, snow: albedo; of rock w: water's
   height above the base (m; below all land: there is none). */
#define TERRAIN_FIELDS(F) \
  F(vec4, lattice) \
  F(ivec4, size) \
  F(vec4, box) \
  F(vec4, altitude) \
  F(vec4, cover) \
  F(vec4, sun) \
  F(vec4, rock) \
  F(vec4, snow)
DECLARE_BLOCK(TerrainBlock, terrain, 3, TERRAIN_FIELDS)
#endif
