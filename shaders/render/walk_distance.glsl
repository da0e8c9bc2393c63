// The way through a layer by its distance field: past clear air as far as it leaves free, and in small steps near cloud (UHawk's bipolar
// march).
#ifndef RENDER_WALK_DISTANCE
#define RENDER_WALK_DISTANCE
#include "render/walk.glsl"
layout(binding = 4) uniform sampler3D distance_field;

// About p (server/bake/distance_field.h): how far there is no cloud (below 0: no clear air), m; how far the noise takes to change by 1, m.
vec2 nearness_of(vec3 p, Land land) {
  float levels = cloud.distance.w;
  float level = clamp(floor((land.threshold - cloud.distance.y) * cloud.distance.z - 1.0e-4), 0.0, levels - 1.0);
  float half_cell = 0.5 * levels / float(textureSize(distance_field, 0).z);
  float height = clamp(height_in_layer(p), half_cell, 1.0 - half_cell);
  return cloud.distance.x * textureLod(distance_field, vec3(tile_at(p) + land.shift, (level + height) / levels), 0.0).xy;
}

// The shortest side of the field's cells, m.
float shortest_cell_m() {
  vec3 cells = vec3(textureSize(distance_field, 0));
  vec3 cell_m = 1.0 / (cells * vec3(cloud.tile.xy, cloud.layer.z / cloud.distance.w));
  return cloud.distance.x * min(cell_m.x, min(cell_m.y, cell_m.z));
}

// Goes on to the next sample in cloud, or to the path's end. Beside cloud, too, there is none before the noise can have risen to the
// threshold. What is free is crossed in a whole number of small steps, so that where these have one length the samples lie where they
// would without the field. Where they grow, the last begins by `jitter` of what they have grown by meanwhile: by less, the field's cells
// would be seen as ribs.
Walk walk_to_cloud(CameraRay ray, Stretch path, float jitter, Walk walk) {
  float growth = 1.0 + cloud.steps.y + cloud.adaptive.y;
  float cell_m = shortest_cell_m();
  walk.shape.value = 0.0;
  bool looking = is_under_way(walk, path);
  do {
    vec3 p = ray.origin + ray.direction * walk.t;
    float small_m = small_step_m(walk.t);
    Land land = land_at(p);
    vec2 nearness_m = nearness_of(p, land);
    float free_m = nearness_m.x;
    Shape shape = Shape(0.0, 1.0);
    if (free_m < small_m) {
      shape = shape_above_threshold(p, land);
      free_m = shape.value > outside_volume ? min(-shape.value * nearness_m.y, cell_m) : 0.0;
    }
    if (looking) walk.land = land, walk.shape = Shape(max(shape.value, 0.0), shape.density);
    looking = looking && shape.value <= 0.0;
    if (looking) {
      float next = walk.t + max(floor(free_m / (small_m * growth)), 1.0) * small_m;
      walk.t = beyond_gap(next + jitter * (small_step_m(next) - small_m) * float(free_m > small_m * growth), path);
      ++walk.steps;
      looking = is_under_way(walk, path);
    }
  } while (looking);
  return walk;
}
#endif
