// The discs of sun and moon in a moving picture: too small and too bright for what is kept from frame to frame, so that
// each frame marches rays of its own for them, as for what is newly seen.
#pragma once
#include "render/resolve_plan.h"

namespace cloudscape::render {

// Column, row and radius in the kept picture, pixels; radius 0: none is in view. Less than a pixel's radius would miss
// the pixels' middles.
struct Discs {
  glm::dvec3 sun_px{0}, moon_px{0};
};
Discs discs_of(const KeptView& now, ImageSize kept);

// Draws them as large as that, and their radiance so much weaker.
void widen_discs(FrameBlock& block, ImageSize kept, double vertical_fov_deg);

}  // namespace cloudscape::render
