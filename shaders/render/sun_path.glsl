// The way of the light through the tile of the clouds, in places: tiles east and north where the clouds stand upright, height 0..1 in
// the layer.
#ifndef RENDER_SUN_PATH
#define RENDER_SUN_PATH
#include "shared/cloud_block.glsl"
#include "lib/intersect.glsl"

const float longest_sun_path_m = 150000.0;  // tuned: of a sun on the horizon, about as long as the planet's curve leaves in a layer

// How far along a ray that rises by `sine` it has risen by `rise_m`: the planet falls away below it.
float distance_to_rise(float rise_m, float sine) {
  float curve = cloud.volume.y / planet_radius_m;
  float both = sine + sqrt(max(0.0, sine * sine + 2.0 * curve * rise_m));
  return both * longest_sun_path_m > 2.0 * rise_m ? 2.0 * rise_m / both : longest_sun_path_m;
}

vec3 place_towards(vec3 place, vec3 direction, float distance_m) {
  float rise_m = distance_m * (direction.z + distance_m * cloud.volume.y / (2.0 * planet_radius_m));
  float rise = rise_m * cloud.layer.z;
  return place + vec3(cloud.tile.xy * (direction.xy * distance_m - cloud.lean.xy * rise), rise);
}

// Where on that way the tile is that stands alone; of one that repeats, everywhere.
vec2 within_tile(vec3 place, vec3 direction) {
  vec2 within = vec2(0.0, longest_sun_path_m);
  for (int i = 0; i < (cloud.box_low.w > 0.0 ? 0 : 1); ++i) {  // a loop, which software leaves out
    vec2 per_m = cloud.tile.xy * (direction.xy - cloud.lean.xy * direction.z * cloud.layer.z);
    vec2 x = intersect_slab(place.x, per_m.x, 0.0, 1.0);
    vec2 y = intersect_slab(place.y, per_m.y, 0.0, 1.0);
    within = vec2(max(max(x.x, y.x), 0.0), min(x.y, y.y));
  }
  return within;
}
#endif
