// How long the small steps of a march are.
#ifndef RENDER_SMALL_STEP
#define RENDER_SMALL_STEP
#include "shared/cloud_block.glsl"

// Length of the small step at a distance from the camera: what the quality asks for, and what the adaptive step adds (Olajos 2.4.2).
float small_step_m(float distance_m) {
  float step_m = max(cloud.steps.x, cloud.steps.y * distance_m) + cloud.adaptive.y * max(0.0, distance_m - cloud.adaptive.x);
  return min(step_m, cloud.volume.x);
}
#endif
