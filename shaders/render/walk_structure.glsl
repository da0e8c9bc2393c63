// The way through a layer by the thesis' structure (Olajos 2.4.2), or in small steps alone.
#ifndef RENDER_WALK_STRUCTURE
#define RENDER_WALK_STRUCTURE
#include "render/structure.glsl"
#include "render/walk.glsl"

// Goes on to the next sample in cloud, or to the path's end. The preprocessed structure of Olajos 2.4.2: large steps outside it;
// one large step back where it begins, and on by what the padding is known to leave free; then as far as its outer layer leaves
// free, and small steps near cloud. It is asked at every step: that costs a quarter of what a sample of the shape does. One loop for
// all kinds of step: a software rasterizer goes through a loop for all of its lanes until the last is done.
//
// `jitter`: the first step as a share of a whole one. Small steps are longer far out than where the ray began, and there begin by
// that share of the longer one: by less, the structure's cells would be seen as ribs.
Walk walk_to_cloud(CameraRay ray, Stretch path, float jitter, Walk walk) {
  float first_m = small_step_m(path.begin);
  float large_m = cloud.structure.x;
  float last = path.end - min(1.0, 0.5 * small_step_m(path.end));  // where the structure is asked for the last time
  walk.shape.value = 0.0;
  bool looking = is_under_way(walk, path);
  do {
    vec3 p = ray.origin + ray.direction * walk.t;
    float small_m = small_step_m(walk.t);
    Land land = land_at(p);
    int place = large_m > small_m ? place_in_structure(p, land) : near_cloud;
    bool steps_back = place != outside_structure && walk.outside >= 0.0;
    Shape shape = Shape(0.0, 1.0);
    if (place == near_cloud && !steps_back) shape = shape_above_threshold(p, land);
    if (looking) walk.land = land, walk.shape = Shape(max(shape.value, 0.0), shape.density);
    looking = looking && shape.value <= 0.0;
    if (looking) {
      float next = beyond_gap(walk.t + (place == in_outer_padding ? max(cloud.structure.w, small_m) : small_m), path);
      if (place == outside_structure) next = beyond_gap(walk.t < last ? min(walk.t + large_m, last) : path.end, path);
      if (steps_back) next = walk.outside + cloud.structure.z + jitter * (small_step_m(walk.outside) - first_m);
      walk.outside = place == outside_structure ? walk.t : -1.0;
      walk.t = next;
      ++walk.steps;
      looking = is_under_way(walk, path);
    }
  } while (looking);
  return walk;
}
#endif
