// What both ways through a layer have in common (walk_distance.glsl, walk_structure.glsl).
#ifndef RENDER_WALK
#define RENDER_WALK
#include "render/camera.glsl"
#include "render/medium.glsl"
#include "render/small_step.glsl"

float beyond_gap(float t, Stretch path) { return t > path.gap_begin && t < path.gap_end ? path.gap_end : t; }

// Where a ray is on its way through the layer.
struct Walk {
  float t;  // of the next sample, m
  float steps;
  Shape shape;    // at t; above 0: in cloud
  Land land;      // there
  float outside;  // the last point outside the thesis' structure, m; < 0: none since the small steps began
};

// Software computes the body of a loop once more after its last round where the condition stands before it, and not where it stands
// behind: all of these loops, which are most of what a frame costs, end in their condition.
bool is_under_way(Walk walk, Stretch path) { return walk.steps < cloud.steps.z && walk.t < path.end; }

// Software keeps what goes round in a loop: of one layer not its density, which is known.
Shape shape_at(Walk walk) { return shape_of(walk.shape.value, walk.shape.density); }

Walk begin_walk(float t) { return Walk(t, 0.0, Shape(0.0, 1.0), Land(0.0, vec2(0.0)), -1.0); }
#endif
