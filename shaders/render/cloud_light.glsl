// Light at a point in the medium: the sun through the medium, and what the sky and the ground add.
#ifndef RENDER_CLOUD_LIGHT
#define RENDER_CLOUD_LIGHT
#include "render/medium.glsl"
#include "render/in_scatter.glsl"
#include "render/sun_depth.glsl"
#include "render/ambient.glsl"
#include "render/phase_table.glsl"
#include "lib/transport.glsl"
layout(binding = 6) uniform sampler2D cloud_sun_table;

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
      Shape shape = shape_above_threshold(at, land);
      sum_m += density_of(shape, erosion_at(at, height_in_layer(at), false), cloud.erosion.z) * (2.0 * i + 1.0);
      ++i;
    } while (i < near);
    do {
      Shape shape = shape_above_threshold(p + sun * light_distance_m(path.begin, end_m, i, jitter), land);
      sum_m += i < steps ? density_of(shape, mean_erosion, cloud.erosion.y) * (2.0 * i + 1.0) : 0.0;
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
  AmbientLight around;
};

float octave_phase(float cos_theta, float broadening) {
  return phase_of_kind(PHASE_KIND, cos_theta, cloud.phase.x, cloud.phase.y, cloud.phase.z, broadening);
}
vec4 octave_phases(float cos_theta, vec4 broadening) {
  return vec4(octave_phase(cos_theta, broadening.x), octave_phase(cos_theta, broadening.y),
              octave_phase(cos_theta, broadening.z), octave_phase(cos_theta, broadening.w));
}

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
  light.around = ambient_light(direction);
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
  return cloud.medium.y * (sun * scatter + ambient(light.around, p, h, land));
}
#endif
