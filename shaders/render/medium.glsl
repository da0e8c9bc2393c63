// The medium: density at a point, and where along a ray there can be any.
#ifndef RENDER_MEDIUM
#define RENDER_MEDIUM
#include "shared/cloud_block.glsl"
#include "lib/intersect.glsl"
layout(binding = 0) uniform sampler3D shape_texture;
layout(binding = 1) uniform sampler3D detail_texture;
layout(binding = 2) uniform sampler2D variation_texture;
layout(binding = 4) uniform sampler3D structure_texture;

const int volume_noise = 0;
const int volume_sphere = 1;
const int volume_box = 2;
const int volume_slab = 3;
const int volume_gaussian = 4;
int volume_kind() { return int(cloud.layer.w); }

vec3 box_center() { return 0.5 * (cloud.box_low.xyz + cloud.box_high.xyz); }
float sphere_radius_m() { return 0.5 * (cloud.box_high.x - cloud.box_low.x); }

// How much of the erosion there is on average, where the detail texture itself is not read (far away, towards the sun).
const float mean_erosion = 0.5;  // tuned: the mean of `erosion_at`

float erosion_at(vec3 p, float h, bool close) {
  vec4 noise = textureLod(detail_texture, p * cloud.detail.x + cloud.detail.yzw, 0.0);
  // Cracks between billows at the tops, wisps at the base (after Schneider and Vos 2015).
  float erosion = mix(noise.y, 1.0 - noise.x, clamp(h * 5.0, 0.0, 1.0));
  if (!close) return erosion;
  // The same texture again, finer: what the eye wants within a kilometre or two. tuned: the ratio is no whole number, so that
  // the two never line up.
  float fine = textureLod(detail_texture, p * (4.7 * cloud.detail.x) + 4.7 * cloud.detail.yzw, 0.0).x;
  return 0.72 * erosion + 0.28 * (1.0 - fine);
}

// The slow change of coverage over the land at a point: the threshold there, and how far the tile is shifted (tiles).
struct Land {
  float threshold;
  vec2 shift;
};

Land land_at(vec3 p) {
  if (cloud.shape.z <= 0.0) return Land(cloud.shape.x, vec2(0.0));
  vec3 slow = textureLod(variation_texture, p.xy * cloud.variation.x + cloud.variation.yz, 0.0).xyz;
  return Land(cloud.shape.x + cloud.shape.z * (slow.x - 0.5), cloud.shape.w * (slow.yz - 0.5));
}

float height_in_layer(vec3 p) { return (altitude_of(p) - cloud.layer.x) * cloud.layer.z; }

// Whether the structure encloses a point: whether there can be cloud near it (Olajos 2.4.2). Its padding is wider than half a large
// step, so that no cloud stands between two points outside that are a large step apart.
bool inside_structure(vec3 p, Land land) {
  vec2 tile = p.xy * cloud.tile.xy + cloud.tile.zw;
  float bound = textureLod(structure_texture, vec3(tile + land.shift, clamp(height_in_layer(p), 0.0, 1.0)), 0.0).x;
  return bound > land.threshold - cloud.structure.y;
}

// Shape noise above the threshold; not above 0: no cloud. What erosion takes off it comes after.
float shape_above_threshold(vec3 p, Land land) {
  float h = height_in_layer(p);
  vec2 tile = p.xy * cloud.tile.xy + cloud.tile.zw;
  vec4 noise = textureLod(shape_texture, vec3(tile + land.shift, h), 0.0);
  float value = noise.x * (1.0 + dot(cloud.weights.yzw, noise.yzw - 0.5)) - land.threshold;
  bool beside = cloud.box_low.w == 0.0 && (tile.x < 0.0 || tile.x > 1.0 || tile.y < 0.0 || tile.y > 1.0);
  return h <= 0.0 || h >= 1.0 || beside ? -1.0 : value;
}

// Density 0..1 from `shape_above_threshold` at p, less `erosion` (0..1), where samples lie `spacing_m` apart.
float density_of(float value, float erosion, float spacing_m) {
  if (value <= 0.0) return 0.0;
  value -= cloud.erosion.x * erosion;
  // tuned: shape noise changes by about this much a metre, so that samples far apart do not fall through thin edges.
  const float shape_per_m = 1.2e-4;
  return clamp(value / (cloud.shape.y + shape_per_m * min(spacing_m, 400.0)), 0.0, 1.0);
}

// The erosion that samples `spacing_m` apart can show: what is finer is left out.
float visible_erosion(vec3 p, float spacing_m) {
  return spacing_m < cloud.erosion.y ? erosion_at(p, height_in_layer(p), spacing_m < cloud.erosion.z) : mean_erosion;
}

// Density 0..1 of the volumes that are not noise, inside their interval.
float analytic_density(vec3 p) {
  if (volume_kind() != volume_gaussian) return 1.0;
  vec3 d = (p - box_center()) / (0.125 * (cloud.box_high.x - cloud.box_low.x));
  return exp(-0.5 * dot(d, d));
}

// Density 0..1 with all its detail, where the medium can be (`medium_stretch`): what a march smooths by the spacing of its samples.
float density_at(vec3 p) {
  if (volume_kind() != volume_noise) return analytic_density(p);
  return density_of(shape_above_threshold(p, land_at(p)), erosion_at(p, height_in_layer(p), true), 0.0);
}

// Up to two stretches of a ray: from begin to end without the gap.
struct Stretch {
  float begin, gap_begin, gap_end, end;
};

Stretch stretch_of(vec2 interval) { return Stretch(max(interval.x, 0.0), no_hit_m, no_hit_m, interval.y); }

// The layer between the lowest and the highest cloud about the planet; from above a ray can enter it twice.
Stretch layer_stretch(vec3 origin, vec3 direction) {
  vec2 top = intersect_altitude(origin, direction, cloud.march.w);
  if (top.x > top.y || top.y <= 0.0) return stretch_of(vec2(1.0, -1.0));
  Stretch found = stretch_of(top);
  vec2 bottom = intersect_altitude(origin, direction, cloud.march.z);
  if (bottom.x > bottom.y || bottom.y <= 0.0) return found;
  if (bottom.x <= found.begin) {
    found.begin = bottom.y;
  } else {
    found.gap_begin = bottom.x;
    found.gap_end = bottom.y;
  }
  return found;
}

Stretch medium_stretch(vec3 origin, vec3 direction) {
  int kind = volume_kind();
  if (kind == volume_noise) return layer_stretch(origin, direction);
  if (kind == volume_sphere) return stretch_of(intersect_sphere(origin, direction, box_center(), sphere_radius_m()));
  if (kind == volume_slab) return stretch_of(intersect_slab(origin.z, direction.z, cloud.box_low.z, cloud.box_high.z));
  return stretch_of(intersect_box(origin, direction, cloud.box_low.xyz, cloud.box_high.xyz));
}
#endif
