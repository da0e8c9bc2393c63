// targets: rgba16f rg32f
// Marches the medium along each ray (Olajos 2.4). Target 0: radiance of the cloud less what its shadow takes from the air, transmittance. Target 1: mean distance of the
// cloud, m (no_hit_m without cloud); share of the sunlight that reaches the ground behind.
#include "render/asked_pixels.glsl"
#include "render/camera.glsl"
#include "render/cloud_light.glsl"
#include "render/shafts.glsl"
#include "lib/hash.glsl"
#include "render/walk.glsl"
#ifdef THESIS_STRUCTURE
#include "render/walk_structure.glsl"
#else
#include "render/walk_distance.glsl"
#endif
layout(binding = 3) uniform sampler2D scene_depth;

struct March {
  vec3 radiance;
  float transmittance;
  float weighted_distance_m;
  float weight;
};

// Offset of the first step in 0..1: differs between neighbouring pixels, and evenly over the samples of a pixel.
float step_jitter(ivec2 pixel) {
  if (cloud.adaptive.z == 0.0) return 0.5;
  float noise = interleaved_gradient_noise(vec2(pixel));
  return fract(noise + golden_ratio * float(frame.sample_info.x));
}

// The same for the samples of the sunlight: by other numbers (Roberts' R2 sequence), so that it does not go with the first step.
float light_jitter(ivec2 pixel) {
  if (cloud.adaptive.z == 0.0) return 0.5;
  return fract(interleaved_gradient_noise(vec2(pixel) + vec2(31.0, 57.0)) + 0.7548776662 * float(frame.sample_info.x));
}

struct Sample {
  vec3 position;
  Land land;
  float distance_m, density, jitter;
};

// One step through medium of the sample's density.
March advance(March march, RayLight light, vec3 direction, Sample at, float step_m) {
  vec2 segment = integrate_segment(at.density * cloud.medium.x, step_m);
  vec3 source = source_radiance(light, at.position, direction, at.land, at.jitter);
  march.radiance += march.transmittance * at.density * segment.x * source;
  float absorbed = march.transmittance * (1.0 - segment.y);
  march.weighted_distance_m += absorbed * at.distance_m;
  march.weight += absorbed;
  march.transmittance *= segment.y;
  return march;
}

// A homogeneous medium is cut into equal steps, whose sum is the whole stretch wherever in its step each sample lies.
March march_analytic(CameraRay ray, RayLight light, Stretch path, float jitter, float stop_transmittance) {
  March march = March(vec3(0.0), 1.0, 0.0, 0.0);
  float step_m = (path.end - path.begin) / cloud.steps.z;
  for (float i = 0.0; i < cloud.steps.z && march.transmittance >= stop_transmittance; ++i) {
    float t = path.begin + (i + jitter) * step_m;
    vec3 p = ray.origin + ray.direction * t;
    Sample at = Sample(p, Land(0.0, vec2(0.0)), t, analytic_density(p), fract(jitter + golden_ratio * i));
    march = advance(march, light, ray.direction, at, step_m);
  }
  return march;
}

March march_layer(CameraRay ray, RayLight light, Stretch path, vec2 jitter, float stop_transmittance) {
  March march = March(vec3(0.0), 1.0, 0.0, 0.0);
  float begin = path.begin + jitter.x * small_step_m(path.begin);
  path.gap_end += jitter.x * small_step_m(path.gap_end);
  Walk walk = begin_walk(begin);
  float lit = 0.0;
  bool going = is_under_way(walk, path);
  do {
    // The loops stand one in the other so that each sample costs no more than it must: look for shape noise, then erode it, and
    // light only what is left.
    float step_m = 0.0, density = 0.0;
    vec3 p = ray.origin;
    bool looking = going;
    do {
      if (looking) walk = walk_to_cloud(ray, path, jitter.x, walk);
      looking = looking && walk.shape.value > 0.0;
      if (looking) {
        step_m = small_step_m(walk.t);
        p = ray.origin + ray.direction * walk.t;
        density = density_of(shape_at(walk), visible_erosion(p, step_m), step_m);
        walk.t = beyond_gap(walk.t + step_m, path);
        ++walk.steps;
        looking = density <= 0.0 && is_under_way(walk, path);
      }
    } while (looking);
    going = going && density > 0.0;
    if (going) {
      // The light's samples differ from one lit step to the next, and not with the distance: that would show as contours.
      float distance_m = dot(p - ray.origin, ray.direction);
      Sample at = Sample(p, walk.land, distance_m, density, fract(jitter.y + golden_ratio * lit));
      ++lit;
      march = advance(march, light, ray.direction, at, min(step_m, 2.0 * (path.end - distance_m)));
      going = march.transmittance >= stop_transmittance && is_under_way(walk, path);
    }
  } while (going);
  return march;
}

March march_ray(CameraRay ray, Stretch path, vec2 jitter, float stop_transmittance) {
  RayLight light = ray_light(ray.direction);
  March march = is_textured() ? march_layer(ray, light, path, jitter, stop_transmittance)
                              : march_analytic(ray, light, path, jitter.x, stop_transmittance);
  if (march.transmittance < stop_transmittance) march.transmittance = 0.0;
  return march;
}

// Share of the sunlight that reaches what lies there.
float ground_visibility(vec3 p) {
  return frame.light_direction.z > 0.02 && has_sun_depth() ? slab_transmittance(sun_depth_at(p)) : 1.0;
}

PassOutput shade(ivec2 target_pixel) {
  ivec2 march_pixel = target_pixel - frame.march_target.xy;
  if (!asked_for(march_pixel)) return PassOutput(vec4(0.0), vec4(0.0));
  int divisor = frame.size.w;
  vec2 pixel = (vec2(march_pixel) + 0.5) * float(divisor);
  CameraRay ray = camera_ray(pixel);
  float depth_m = texelFetch(scene_depth, min(ivec2(pixel), frame.size.xy - 1) + frame.march_target.xy, 0).x;
  bool ground = depth_m < no_hit_m && depth_m > 0.0;
  float visibility = 1.0;
  if (ground) visibility = ground_visibility(ray.origin + ray.direction * depth_m);
  Stretch path = medium_stretch(ray.origin, ray.direction);
  path.end = min(min(path.end, depth_m), cloud.march.y);
  bool marched = ray.valid > 0.0 && path.end > path.begin && cloud.medium.x > 0.0;
  // The sun's disc is 20,000 times brighter than a cloud: before it even thin remainders of it can be seen.
  float stop = dot(ray.direction, frame.light_direction.xyz) > 0.9995 ? 1.0e-6 : 0.003;
  vec2 jitter = vec2(step_jitter(march_pixel), light_jitter(march_pixel));
  March march = March(vec3(0.0), 1.0, 0.0, 0.0);
  if (marched) march = march_ray(ray, path, jitter, stop);
  float distance_m = march.weight > 0.0 ? march.weighted_distance_m / march.weight : no_hit_m;
  Air air = air_to(ray.direction, distance_m);
  AirShadow shadow = air_shadow(ray, depth_m, distance_m, jitter.y);
  float opacity = 1.0 - march.transmittance;
  vec3 radiance = march.radiance * air.transmittance + opacity * (air.in_scatter - shadow.before) - march.transmittance * shadow.behind;
  radiance = clamp(radiance * frame.accumulation.z, vec3(-frame.accumulation.y), vec3(frame.accumulation.y));
  return PassOutput(vec4(radiance, march.transmittance), vec4(distance_m, visibility, 0.0, 0.0));
}
