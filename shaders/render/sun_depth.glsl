// Looking up how much cloud stands between a point and the light (render/sun_depth.comp).
#ifndef RENDER_SUN_DEPTH
#define RENDER_SUN_DEPTH
#include "render/medium.glsl"
#include "render/phase_table.glsl"
#include "render/slab.glsl"
#include "render/sun_path.glsl"
#include "shared/frame_block.glsl"
#ifndef PHASE_KIND
#define PHASE_KIND int(cloud.medium.w)
#endif
layout(binding = 13) uniform sampler3D sun_depth_volume;

// Whether there are clouds that the volume is of.
bool has_sun_depth() { return is_textured() && cloud.march.w > cloud.march.z && cloud.medium.x > 0.0; }

// Of a volume of the clouds' grid, at a point in the layer or beyond it, between the levels about the threshold there.
vec4 in_light_volume(sampler3D volume, vec3 p, Land land) {
  float levels = cloud.in_scatter_scale.w;
  float layers = float(textureSize(volume, 0).z) / levels;
  float altitude_m = cloud.layer.x + height_in_layer(p) / cloud.layer.z;
  float up = clamp((altitude_m - cloud.march.z) / (cloud.march.w - cloud.march.z), 0.0, 1.0);
  vec2 across = tile_at(p) + land.shift;
  vec2 level = light_level(land);
  int count = levels > 1.0 ? 2 : 1;  // a loop, which software goes through as often as it must
  vec4 sum = vec4(0.0);
  int i = 0;
  do {
    float row = (level.x + float(i)) * layers + 0.5 + up * (layers - 1.0);
    float share = i == 0 ? 1.0 - level.y : level.y;
    sum += share * textureLod(volume, vec3(across, row / (layers * levels)), 0.0);
  } while (++i < count);
  return sum;
}

float sun_depth_in_layer(vec3 p, Land land) { return cloud.medium.x * in_light_volume(sun_depth_volume, p, land).x; }

// Optical depth between any point and the light: beneath the clouds that of where its light leaves them.
float sun_depth_at(vec3 p) {
  vec3 light = frame.light_direction.xyz;
  float sine = light.z + cloud.volume.y * dot(p.xy, light.xy) / planet_radius_m;
  float below_m = cloud.march.z - cloud.layer.x - height_in_layer(p) / cloud.layer.z;
  vec2 within = within_tile(vec3(tile_at(p), 0.0), light);
  float distance_m = max(below_m > 0.0 ? distance_to_rise(below_m, sine) : 0.0, within.x);
  if (distance_m >= within.y) return 0.0;
  vec3 leaves = p + light * distance_m;
  return sun_depth_in_layer(leaves, land_at(leaves));
}

// Whether cloud.phase.x is a mean cosine.
bool phase_has_asymmetry() { return PHASE_KIND <= 1 || PHASE_KIND == phase_mie; }
#endif
