// Looking up how much cloud stands between a point and the light (render/sun_depth.comp).
#ifndef RENDER_SUN_DEPTH
#define RENDER_SUN_DEPTH
#include "render/medium.glsl"
#include "render/phase_table.glsl"
#include "render/sun_path.glsl"
#include "shared/frame_block.glsl"
#ifndef PHASE_KIND
#define PHASE_KIND int(cloud.medium.w)
#endif
layout(binding = 13) uniform sampler3D sun_depth_volume;

// Whether there are clouds that the volume is of.
bool has_sun_depth() { return is_textured() && cloud.march.w > cloud.march.z && cloud.medium.x > 0.0; }

// At a point in the layer or beyond it, between the levels about the threshold there.
float sun_depth_in_layer(vec3 p, Land land) {
  float levels = cloud.in_scatter_scale.w;
  float layers = float(textureSize(sun_depth_volume, 0).z) / levels;
  float altitude_m = cloud.layer.x + height_in_layer(p) / cloud.layer.z;
  float up = clamp((altitude_m - cloud.march.z) / (cloud.march.w - cloud.march.z), 0.0, 1.0);
  vec2 across = tile_at(p) + land.shift;
  vec2 level = light_level(land);
  int count = levels > 1.0 ? 2 : 1;  // a loop, which software goes through as often as it must
  float depth_m = 0.0;
  int i = 0;
  do {
    float row = (level.x + float(i)) * layers + 0.5 + up * (layers - 1.0);
    float share = i == 0 ? 1.0 - level.y : level.y;
    depth_m += share * textureLod(sun_depth_volume, vec3(across, row / (layers * levels)), 0.0).x;
  } while (++i < count);
  return depth_m * cloud.medium.x;
}

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

// The clouds' mean cosine, where they scatter forwards.
float forwardness() {
  return phase_has_asymmetry() ? max(cloud.phase.x, 0.0) : 0.0;
}

// Beam and diffuse light together: transmittance of a conservative slab by the two-stream equations (Bohren 1987).
float slab_transmittance(float optical_depth) { return 1.0 / (1.0 + 0.75 * (1.0 - forwardness()) * optical_depth); }
#endif
