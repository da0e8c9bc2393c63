// What both ways through a layer have in common (walk_distance.glsl, walk_structure.glsl).
#ifndef RENDER_WALK
#define RENDER_WALK
#include "render/camera.glsl"
#include "render/medium.glsl"

// Length of the small step at a distance from the camera: what the quality asks for, and what the adaptive step adds (Olajos 2.4.2).
float small_step_m(float distance_m) {
  float step_m = max(cloud.steps.x, cloud.steps.y * distance_m) + cloud.adaptive.y * max(0.0, distance_m - cloud.adaptive.x);
  return min(step_m, cloud.volume.x);
}

float beyond_gap(float t, Stretch path) { return t > path.gap_begin && t < path.gap_end ? path.gap_end : t; }

// Where a ray is on its way through the layer.
struct Walk {
  float t;  // of the next sample, m
  float steps;
  float value;    // shape noise above the threshold at t; above 0: in cloud
  Land land;      // there
  float outside;  // the last point outside the thesis' structure, m; < 0: none since the small steps began
};

Walk begin_walk(float t) { return Walk(t, 0.0, 0.0, Land(0.0, vec2(0.0)), -1.0); }
#endif
