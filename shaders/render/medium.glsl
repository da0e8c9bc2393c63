// The medium: density at a point, and where along a ray there can be any.
#ifndef RENDER_MEDIUM
#define RENDER_MEDIUM
#include "shared/cloud_block.glsl"
#include "lib/intersect.glsl"
layout(binding = 0) uniform sampler3D shape_texture;
layout(binding = 1) uniform sampler3D detail_texture;
layout(binding = 2) uniform sampler2D variation_texture;

const int volume_noise = 0;
const int volume_sphere = 1;
const int volume_box = 2;
const int volume_slab = 3;
const int volume_gaussian = 4;
const int volume_grid = 5;  // voxels from a file: both of core's kinds
#ifndef VOLUME_KIND
#define VOLUME_KIND int(cloud.layer.w)
#endif
int volume_kind() { return VOLUME_KIND; }

// Whether density comes from the shape texture and not from a formula.
bool is_textured() { return volume_kind() == volume_noise || volume_kind() == volume_grid; }

vec3 box_center() { return 0.5 * (cloud.box_low.xyz + cloud.box_high.xyz); }
float sphere_radius_m() { return 0.5 * (cloud.box_high.x - cloud.box_low.x); }

// 0..1 from the bottom of the volume to its top, which is bent with the planet or flat.
float height_in_layer(vec3 p) {
  float drop_m = cloud.volume.y * (p.x * p.x + p.y * p.y) / (2.0 * (planet_radius_m + p.z));  // as altitude_of
  return (p.z + drop_m - cloud.layer.x) * cloud.layer.z;
}

// Where what is at p would be if the wind did not make the clouds lean: all of their shape is looked up there.
vec3 upright(vec3 p) { return vec3(p.xy - cloud.lean.xy * height_in_layer(p), p.z); }
vec2 tile_at(vec3 p) { return upright(p).xy * cloud.tile.xy + cloud.tile.zw; }

// How much of the erosion there is on average, where the detail texture itself is not read (far away, towards the sun).
const float mean_erosion = 0.5;  // tuned: the mean of `erosion_at`

float erosion_at(vec3 p, float h, bool close) {
  p = upright(p);
  vec4 noise = textureLod(detail_texture, p * cloud.detail.x + cloud.detail.yzw, 0.0);
  // Cracks between billows at the tops, wisps at the base (after Schneider and Vos 2015).
  float erosion = mix(noise.y, 1.0 - noise.x, clamp(h * 5.0, 0.0, 1.0));
  if (!close) return erosion;
  // The same texture again, finer: what the eye wants within a kilometre or two.
  float fine = textureLod(detail_texture, p * cloud.fine_detail.x + cloud.fine_detail.yzw, 0.0).x;
  return 0.72 * erosion + 0.28 * (1.0 - fine);
}

// The slow change of coverage over the land at a point: the threshold there, and how far the tile is shifted (tiles).
struct Land {
  float threshold;
  vec2 shift;
};

Land land_at(vec3 p) {
#ifdef EVEN_COVERAGE
  return Land(cloud.shape.x, vec2(0.0));
#endif
  vec2 at = upright(p).xy;
  if (cloud.shape.z <= 0.0) return Land(cloud.shape.x, vec2(0.0));
  vec3 slow = textureLod(variation_texture, at * cloud.variation.x + cloud.variation.yz, 0.0).xyz;
  return Land(cloud.shape.x + cloud.shape.z * (slow.x - 0.5), cloud.shape.w * (slow.yz - 0.5));
}

// Volumes of light are of some levels of the threshold, one above the other: the lower of the two about the land's, and its distance from
// that (0..1, in levels).
vec2 light_level(Land land) {
  float levels = cloud.in_scatter_scale.w;
  float level = clamp((land.threshold - cloud.in_scatter_levels.x) * cloud.in_scatter_levels.y, 0.0, levels - 1.0);
  float lower = min(floor(level), max(levels - 2.0, 0.0));
  return vec2(lower, level - lower);
}

const float outside_volume = -1.0;  // as a value of the shape: lower than any inside

#ifndef LAYERED
#define LAYERED (cloud.volume.w > 0.0)
#endif

// What the shape texture says of a point.
struct Shape {
  float value;    // noise above the threshold; not above 0: no cloud. What erosion takes off it comes after.
  float density;  // 0..1, as dense as the cloud can be: of several layers that of the one that is there
};

// Of texels of one layer, which is as dense as the medium, green is something else.
Shape shape_of(float value, float green) { return Shape(value, LAYERED ? green : 1.0); }

Shape shape_above_threshold(vec3 p, Land land) {
  float h = height_in_layer(p);
  vec2 tile = tile_at(p);
  vec4 noise = textureLod(shape_texture, vec3(tile + land.shift, h), 0.0);
  float value = noise.x * (1.0 + dot(cloud.weights.yzw, noise.yzw - 0.5)) - land.threshold;
  bool beside = cloud.box_low.w == 0.0 && (tile.x < 0.0 || tile.x > 1.0 || tile.y < 0.0 || tile.y > 1.0);
  return shape_of(h <= 0.0 || h >= 1.0 || beside ? outside_volume : value, noise.y);
}

// Density 0..1 from `shape_above_threshold` at p, less `erosion` (0..1), where samples lie `spacing_m` apart.
float density_of(Shape shape, float erosion, float spacing_m) {
  if (shape.value <= 0.0) return 0.0;
  float value = shape.value - cloud.erosion.x * erosion;
  return shape.density * clamp(value / (cloud.shape.y + cloud.erosion.w * min(spacing_m, 400.0)), 0.0, 1.0);
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
  if (!is_textured()) return analytic_density(p);
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

// Between the lowest and the highest voxel with density; as wide as the grid, or without end where it tiles.
Stretch grid_stretch(vec3 origin, vec3 direction) {
  vec2 heights = intersect_slab(origin.z, direction.z, cloud.march.z, cloud.march.w);
  if (cloud.box_low.w > 0.0) return stretch_of(heights);
  vec2 x = intersect_slab(origin.x, direction.x, cloud.box_low.x, cloud.box_high.x);
  vec2 y = intersect_slab(origin.y, direction.y, cloud.box_low.y, cloud.box_high.y);
  return stretch_of(vec2(max(max(x.x, y.x), heights.x), min(min(x.y, y.y), heights.y)));
}

Stretch medium_stretch(vec3 origin, vec3 direction) {
  int kind = volume_kind();
  if (kind == volume_noise) return layer_stretch(origin, direction);
  if (kind == volume_grid) return grid_stretch(origin, direction);
  if (kind == volume_sphere) return stretch_of(intersect_sphere(origin, direction, box_center(), sphere_radius_m()));
  if (kind == volume_slab) return stretch_of(intersect_slab(origin.z, direction.z, cloud.box_low.z, cloud.box_high.z));
  return stretch_of(intersect_box(origin, direction, cloud.box_low.xyz, cloud.box_high.xyz));
}
#endif
