// Light at a point in the medium: the sun through the medium, and what the sky and the ground add.
#ifndef RENDER_CLOUD_LIGHT
#define RENDER_CLOUD_LIGHT
#include "render/medium.glsl"
#include "render/in_scatter.glsl"
#include "render/sun_depth.glsl"
#include "render/sky.glsl"
#include "render/phase_table.glsl"
#include "lib/transport.glsl"
layout(binding = 6) uniform sampler2D cloud_sun_table;
layout(binding = 15) uniform sampler3D ambient_visibility;  // render/ambient_visibility.comp

const int light_single = 0;
const int light_olajos = 1;
const int light_beer_powder = 3;
const int light_in_scatter_volume = 4;
bool lighting() { return cloud.adaptive.w > 0.0; }

// Where the sample of light step i lies: the steps end at the squares of their number's share.
float light_distance_m(float begin_m, float end_m, float i, float jitter) {
  float share = (i * i + jitter * (2.0 * i + 1.0)) / (cloud.steps.w * cloud.steps.w);
  return mix(begin_m, end_m, share);
}

// Optical depth from p towards the sun along `path`, as far as the light is marched. Steps grow with the square of their number: near
// occluders matter most. `jitter` (0..1) places the samples in their steps: what few samples miss becomes noise, which averages out,
// and not contours. `land` is that of p: it hardly changes over the way to the sun.
float near_optical_depth(vec3 p, Stretch path, Land land, float jitter) {
  vec3 sun = frame.light_direction.xyz;
  float end_m = min(path.end, cloud.march.x);
  if (end_m <= path.begin) return 0.0;
  if (!is_textured() && volume_kind() != volume_gaussian)
    return cloud.medium.x * (path.end - path.begin);
  float steps = cloud.steps.w;
  float sum_m = 0.0;
  if (volume_kind() == volume_gaussian) {
    for (float i = 0.0; i < steps; ++i)
      sum_m += analytic_density(p + sun * light_distance_m(path.begin, end_m, i, jitter)) * (2.0 * i + 1.0);
  } else {
    // tuned: the two nearest samples see the detail that shades the surface, the others do not.
    float near = min(steps, 2.0), i = 0.0;
    do {
      vec3 at = p + sun * light_distance_m(path.begin, end_m, i, jitter);
      float value = shape_above_threshold(at, land);
      sum_m += density_of(value, erosion_at(at, height_in_layer(at), false), cloud.erosion.z) * (2.0 * i + 1.0);
      ++i;
    } while (i < near);
    do {
      float value = shape_above_threshold(p + sun * light_distance_m(path.begin, end_m, i, jitter), land);
      sum_m += i < steps ? density_of(value, mean_erosion, cloud.erosion.y) * (2.0 * i + 1.0) : 0.0;
      ++i;
    } while (i < steps);
  }
  return sum_m * (end_m - path.begin) * cloud.medium.x / (steps * steps);
}

#ifndef LIGHT_KIND
#define LIGHT_KIND int(cloud.phase.w)
#endif
bool light_from_grid() { return LIGHT_KIND == light_in_scatter_volume; }

// All of it: a volume knows what stands farther away.
float sun_optical_depth(vec3 p, Land land, float jitter) {
  vec3 sun = frame.light_direction.xyz;
  Stretch path = medium_stretch(p, sun);
  float depth = near_optical_depth(p, path, land, jitter);
  float far_m = max(cloud.march.x, path.begin);
  if (light_from_grid() && path.end > far_m) depth += far_optical_depth(in_scatter_place(p + far_m * sun, land));
  if (has_sun_depth() && !light_from_grid() && path.end > far_m) depth += sun_depth_in_layer(p + far_m * sun, land);
  return depth;
}

// What stays the same along a view ray: phase values of the sun, by octave, and the colours of the light.
struct RayLight {
  vec3 phase;                      // of the first order, by colour
  vec4 octaves_low, octaves_high;  // of the others: weight times phase
  float little;                    // of light that was scattered but little, for the in-scatter volume
  vec3 above, beside, below;       // of sky and ground, as far as it is scattered towards the camera
  mat3 parts;                      // the same, scattered evenly
  vec3 part_weights;               // above, beside, below: as of a light of 1 from everywhere
};

float octave_phase(float cos_theta, float broadening) {
  return phase_of_kind(PHASE_KIND, cos_theta, cloud.phase.x, cloud.phase.y, cloud.phase.z, broadening);
}
vec4 octave_phases(float cos_theta, vec4 broadening) {
  return vec4(octave_phase(cos_theta, broadening.x), octave_phase(cos_theta, broadening.y),
              octave_phase(cos_theta, broadening.z), octave_phase(cos_theta, broadening.w));
}

// Light of a part of the sphere goes on in its own direction rather than back: a phase function of two terms, (1 + 3 g cos) / 4 pi,
// which is never negative up to g = 1/3. tuned: what is left of the droplets' asymmetry after some orders.
float ambient_asymmetry() {
  return phase_has_asymmetry() ? clamp(0.4 * cloud.phase.x, -0.33, 0.33) : 0.0;
}
// `solid_angle`: the part's share of the sphere. `cosine`: mean of that between its directions and the view ray's. All weights add up to 1.
float ambient_weight(float solid_angle, float cosine, float g) { return solid_angle * (1.0 + 3.0 * g * cosine); }

const vec3 part_share = vec3(0.25, 0.25, 0.5);  // of the sphere: above, beside, below

RayLight ray_light(vec3 direction) {
  RayLight light;
  float cos_theta = dot(direction, frame.light_direction.xyz);
  bool table = PHASE_KIND == phase_mie;
  light.phase = table ? mie_phase(direction, frame.light_direction.xyz) : vec3(octave_phase(cos_theta, 1.0));
  // Light that was scattered some times, and goes on by a broader function. tuned: of g = 0.85 between that of two times
  // (0.85 of it) and of three (0.72).
  light.little = octave_phase(cos_theta, 0.76);
  light.octaves_low = vec4(0.0, cloud.octave_weight_low.yzw) * octave_phases(cos_theta, cloud.octave_asymmetry_low);
  light.octaves_high = vec4(0.0);
  if (cloud.octave_weight_high.x > 0.0)
    light.octaves_high = cloud.octave_weight_high * octave_phases(cos_theta, cloud.octave_asymmetry_high);
  vec2 azimuth = from_light_azimuth(direction.xy);
  float g = ambient_asymmetry();
  vec3 beside = surroundings(1) + surroundings(2) + surroundings(3) + surroundings(4);
  light.parts = mat3(surroundings(0) * part_share.x, beside * (0.25 * part_share.y), surroundings(5) * part_share.z);
  light.part_weights = part_share * (1.0 + 3.0 * g * direction.z * vec3(0.75, 0.25, -0.5));
  light.above = surroundings(0) * light.part_weights.x;
  light.below = surroundings(5) * light.part_weights.z;
  light.beside = surroundings(1) * ambient_weight(0.0625, 0.87 * azimuth.x + 0.25 * direction.z, g) +
                 surroundings(2) * ambient_weight(0.0625, 0.87 * azimuth.y + 0.25 * direction.z, g) +
                 surroundings(3) * ambient_weight(0.0625, -0.87 * azimuth.x + 0.25 * direction.z, g) +
                 surroundings(4) * ambient_weight(0.0625, -0.87 * azimuth.y + 0.25 * direction.z, g);
  return light;
}

// Irradiance by the sun or the moon at p, height h (0..1) in the layer.
vec3 sun_at(vec3 p, float h) {
  float towards = dot(frame.light_direction.xy, p.xy) * (0.5 / (planet_radius_m * cloud_sun_span));
  return textureLod(cloud_sun_table, vec2(table_u(0.5 + towards, cloud_sun_size.x), table_u(h, cloud_sun_size.y)), 0.0).xyz;
}

// Sunlight scattered towards the camera per unit of irradiance, 1/sr.
vec3 sun_scatter(RayLight light, float optical_depth) {
  int kind = LIGHT_KIND;
  if (kind == light_single) return light.phase * exp(-optical_depth);
  if (kind == light_olajos) {
    return light.phase * exp(-optical_depth) +
           vec3(cloud.olajos.z * phase_isotropic * olajos_light(optical_depth, cloud.olajos.x, cloud.olajos.y));
  }
  if (kind == light_beer_powder) return light.phase * beer_powder(optical_depth);
  vec4 beams = exp(-optical_depth * cloud.octave_extinction_low);
  float sum = dot(light.octaves_low, beams);
  if (cloud.octave_weight_high.x > 0.0) sum += dot(light.octaves_high, exp(-optical_depth * cloud.octave_extinction_high));
  return light.phase * beams.x + vec3(sum);
}

// Light of sky and ground scattered towards the camera at p, height h (0..1) in the medium. What the cloud hides of them is as bright as
// p itself: so that as much comes out of a cloud that absorbs nothing as goes in.
vec3 visible_ambient(RayLight light, vec3 p, Land land) {
  vec3 seen = in_light_volume(ambient_visibility, p, land).xyz;
  float albedo = cloud.medium.y / cloud.medium.x;
  float open = dot(seen, part_share);
  vec3 inside = light.parts * seen * (albedo / (1.0 - albedo * (1.0 - open)));
  return light.above * seen.x + light.beside * seen.y + light.below * seen.z + inside * (1.0 - dot(light.part_weights, seen));
}

// tuned, where there is no volume of visibility: the sky is hidden by the cloud above, the horizon by the cloud beside and the ground by
// the cloud below, in proportion to the height.
vec3 ambient_by_height(RayLight light, float h) {
  float above = mix(0.3, 1.0, smoothstep(0.0, 1.0, h));
  float beside = mix(0.5, 0.9, h);
  float below = (1.0 - h) * (1.0 - h);
  return light.above * above + light.beside * beside + light.below * below;
}

vec3 ambient(RayLight light, vec3 p, float h, Land land) {
  return cloud.medium.z * (has_sun_depth() ? visible_ambient(light, p, land) : ambient_by_height(light, h));
}

// tuned: optical depths beyond differ less and less, in what light there is as in what one sees. Without it the grid's cells stand out in
// dark clouds; more is nearer to the reference.
const float shade_depth = 3.0;

// All light scattered towards the camera at p, where the sun's irradiance is `sun`: the first order by the phase function; light that
// was scattered but little, and so is still about the sun, by a broader one; and all else from the grid, shaded by how much deeper in
// the cloud the point lies than the grid knows.
vec3 light_from_volume(RayLight light, vec3 p, vec3 direction, Land land, vec3 sun, float optical_depth) {
  vec4 others = in_scattered(in_scatter_place(p, land), direction);
  float beam = exp(-optical_depth);
  float depth_of_peak = optical_depth * (1.0 - cloud.in_scatter_levels.z);
  float little = light.little * (exp(-depth_of_peak) - beam);
  float deeper = shade_depth * (exp(-depth_on_grid(others.w) / shade_depth) - exp(-depth_of_peak / shade_depth));
  float shade = exp(-cloud.in_scatter_levels.w * max(deeper, 0.0));
  return sun * (light.phase * beam + vec3(little)) + others.xyz * shade;
}

// Radiance scattered per metre at density 1.
vec3 source_radiance(RayLight light, vec3 p, vec3 direction, Land land, float jitter) {
  float h = clamp(height_in_layer(p), 0.0, 1.0);
  vec3 sun = sun_at(p, h);
  float optical_depth = lighting() ? sun_optical_depth(p, land, jitter) : 0.0;
  if (lighting() && light_from_grid()) return cloud.medium.y * light_from_volume(light, p, direction, land, sun, optical_depth);
  // tuned: without lighting all of the cloud is as bright as a white diffuse surface that the sun strikes at 60 degrees.
  vec3 scatter = vec3(0.5 / pi);
  if (lighting()) scatter = sun_scatter(light, optical_depth);
  if (LIGHT_KIND == light_olajos)
    return cloud.medium.y * sun * (cloud.olajos_dark.xyz / pi + cloud.olajos_bright.xyz * scatter);
  return cloud.medium.y * (sun * scatter + ambient(light, p, h, land));
}
#endif
