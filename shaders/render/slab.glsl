// What comes through a cloud as if it were a slab.
#ifndef RENDER_SLAB
#define RENDER_SLAB
#include "shared/cloud_block.glsl"

// The clouds' mean cosine, where they scatter forwards.
float forwardness() { return max(cloud.in_scatter_offset.w, 0.0); }

// Beam and diffuse light together: transmittance of a conservative slab by the two-stream equations (Bohren 1987).
float slab_transmittance(float optical_depth) { return 1.0 / (1.0 + 0.75 * (1.0 - forwardness()) * optical_depth); }
#endif
