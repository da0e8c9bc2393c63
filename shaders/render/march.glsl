// targets: rgba16f rg32f
// Marches the medium along each ray (Olajos 2.4). Target 0: radiance of the cloud, transmittance. Target 1: mean distance of the
// cloud, m (no_hit_m without cloud); share of the sunlight that reaches the ground behind.
#include "render/camera.glsl"
#include "render/cloud_light.glsl"
#include "lib/hash.glsl"
layout(binding = 3) uniform sampler2D scene_depth;

const float golden_ratio = 0.61803398875;

struct March {
  vec3 radiance;
  float transmittance;
  float weighted_distance_m;
  float weight;
};

// Offset of the first step in 0..1: differs between neighbouring pixels, and evenly over the samples of a pixel.
float step_jitter(ivec2 pixel) {
  float noise = interleaved_gradient_noise(vec2(pixel));
  return fract(noise + golden_ratio * float(frame.sample_info.x));
}

// A homogeneous medium is cut into equal steps, whose sum is the whole stretch wherever in its step each sample lies.
float step_length_m(float distance_m, float stretch_m) {
  if (volume_kind() != volume_noise) return stretch_m / cloud.steps.z;
  return max(cloud.steps.x, cloud.steps.y * distance_m);
}

struct Sample {
  vec3 position;
  Land land;
  float distance_m, density, jitter;
};

// One step through medium of the sample's density.
March advance(March march, RayLight light, Sample at, float step_m) {
  vec2 segment = integrate_segment(at.density * cloud.medium.x, step_m);
  march.radiance += march.transmittance * at.density * segment.x * source_radiance(light, at.position, at.land, at.jitter);
  float absorbed = march.transmittance * (1.0 - segment.y);
  march.weighted_distance_m += absorbed * at.distance_m;
  march.weight += absorbed;
  march.transmittance *= segment.y;
  return march;
}

March march_ray(CameraRay ray, Stretch path, float jitter, bool odd, float stop_transmittance) {
  RayLight light = ray_light(ray.direction);
  March march = March(vec3(0.0), 1.0, 0.0, 0.0);
  float stretch_m = path.end - path.begin;
  float step_m = step_length_m(path.begin, stretch_m);
  float t = path.begin + jitter * step_m;
  int empty = 0;
  bool layer = volume_kind() == volume_noise;
  for (int i = 0; i < int(cloud.steps.z) && (t < path.end || !layer); ++i) {
    if (t > path.gap_begin && t < path.gap_end) t = path.gap_end + jitter * step_m;
    vec3 p = ray.origin + ray.direction * t;
    step_m = step_length_m(t, stretch_m);
    Land land = land_at(p);
    float density = density_at(p, land, step_m);
    if (density > 0.0) {
      if (empty > 4) {  // came with a double step: go back one, so that the edge is not cut
        empty = 0;
        t -= step_m;
        continue;
      }
      empty = 0;
      float length_m = layer ? min(step_m, 2.0 * (path.end - t)) : step_m;
      march = advance(march, light, Sample(p, land, t, density, fract(jitter + golden_ratio * float(i))), length_m);
      if (march.transmittance < stop_transmittance) {
        march.transmittance = 0.0;
        break;
      }
    } else if (layer) {
      ++empty;
    }
    // Through empty air in double steps. Every other pixel and sample begins them one step later: all would else leave out the
    // same places, and no number of samples would fill the gaps.
    t += empty > 4 || (empty == 4 && odd) ? 2.0 * step_m : step_m;
  }
  return march;
}

// Beam and diffuse light together: transmittance of a conservative slab by the two-stream equations (Bohren 1987).
float ground_visibility(CameraRay ray, float distance_m, float jitter) {
  if (frame.sun_direction.z <= 0.02 || volume_kind() != volume_noise) return 1.0;
  float g = cloud.medium.w <= 1.0 ? max(cloud.phase.x, 0.0) : 0.0;
  vec3 p = ray.origin + ray.direction * distance_m;
  // The clouds that shade it stand where the sun is, not above it.
  vec3 above = p + frame.sun_direction.xyz * (cloud.march.z / max(frame.sun_direction.z, 0.05));
  float optical_depth = sun_optical_depth(p, land_at(above), jitter);
  return 1.0 / (1.0 + 0.75 * (1.0 - g) * optical_depth);
}

PassOutput shade(ivec2 march_pixel) {
  int divisor = frame.size.w;
  vec2 pixel = (vec2(march_pixel) + 0.5) * float(divisor);
  CameraRay ray = camera_ray(pixel);
  float depth_m = texelFetch(scene_depth, min(ivec2(pixel), frame.size.xy - 1), 0).x;
  float visibility = depth_m < no_hit_m && depth_m > 0.0 ? ground_visibility(ray, depth_m, step_jitter(march_pixel)) : 1.0;
  Stretch path = medium_stretch(ray.origin, ray.direction);
  path.end = min(min(path.end, depth_m), cloud.march.y);
  if (ray.valid == 0.0 || path.end <= path.begin || cloud.medium.x <= 0.0)
    return PassOutput(vec4(0.0, 0.0, 0.0, 1.0), vec4(no_hit_m, visibility, 0.0, 0.0));
  // The sun's disc is 20,000 times brighter than a cloud: before it even thin remainders of it can be seen.
  float stop = dot(ray.direction, frame.sun_direction.xyz) > 0.9995 ? 1.0e-6 : 0.003;
  bool odd = ((march_pixel.x + march_pixel.y + frame.sample_info.x) & 1) == 1;
  March march = march_ray(ray, path, step_jitter(march_pixel), odd, stop);
  if (march.weight <= 0.0) return PassOutput(vec4(0.0, 0.0, 0.0, 1.0), vec4(no_hit_m, visibility, 0.0, 0.0));
  float distance_m = march.weighted_distance_m / march.weight;
  Air air = air_to(ray.direction, distance_m, altitude_of(ray.origin + ray.direction * distance_m));
  vec3 radiance = march.radiance * air.transmittance + (1.0 - march.transmittance) * air.in_scatter;
  return PassOutput(vec4(radiance, march.transmittance), vec4(distance_m, visibility, 0.0, 0.0));
}
