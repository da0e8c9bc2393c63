// targets: rgba16f r32f
// The scene without clouds: sky, sun's disc, curved ground or terrain. Target 0: radiance, and the share of it that is direct sunlight (so
// that cloud shadows can be taken off later). Target 1: distance along the ray, m; no_hit_m for sky, below 0 where it was not asked for.
#include "render/asked_pixels.glsl"
#include "render/camera.glsl"
#include "render/sky_above.glsl"
#include "render/terrain.glsl"
#ifdef WITH_WATER
#include "render/water.glsl"
#endif

const float ground_plain = 1.0;
const float ground_terrain = 2.0;

Surface plain_surface(CameraRay ray, float distance_m) {
  vec3 p = ray.origin + ray.direction * distance_m;
  float pixel_angle = frame.size.z == 0 ? 2.0 * frame.lens.x / float(frame.size.y) : 2.0 / float(frame.size.y);
  float footprint_m = frame.accumulation.w * distance_m * pixel_angle / max(0.02, abs(ray.direction.z));
  vec3 albedo = frame.ground_albedo.xyz * ground_tint(p.xy + frame.ground.yz, footprint_m, frame.ground_albedo.w);
  vec3 up = normalize(vec3(p.xy, p.z + planet_radius_m));
  float mu = dot(up, frame.light_direction.xyz);
  return Surface(albedo / pi * light_at(0.0, mu) * max(mu, 0.0), albedo / pi * sky_irradiance());
}

PassOutput shade(ivec2 target_pixel) {
  ivec2 pixel = target_pixel - frame.march_target.xy;
  CameraRay ray = camera_ray(vec2(pixel) + 0.5);
  if (!asked_for(pixel)) return PassOutput(vec4(0.0), vec4(-1.0));
  if (ray.valid == 0.0) return PassOutput(vec4(0.0), vec4(0.0));
  vec2 planet = intersect_altitude(ray.origin, ray.direction, 0.0);
  float planet_m = planet.x <= planet.y && planet.y > 0.0 ? max(planet.x, 0.0) : no_hit_m;
  float land_m = no_hit_m;
#ifdef WITH_TERRAIN
  if (frame.ground.x == ground_terrain) land_m = land_distance_m(ray);
#endif
  float distance_m = land_m < no_hit_m ? land_m : (frame.ground.x == ground_plain ? planet_m : no_hit_m);
  Surface surface = Surface(vec3(0.0), vec3(0.0));
#ifndef WITH_WATER  // which lies on the plain
  if (land_m >= no_hit_m && distance_m < no_hit_m) surface = plain_surface(ray, distance_m);
#endif
#ifdef WITH_TERRAIN
  if (land_m < no_hit_m) surface = terrain_surface_at(ray, land_m);
#endif
#ifdef WITH_WATER
  float water_m = water_distance_m(ray);
  int wet = water_m < no_hit_m && water_m <= distance_m ? 1 : 0;
  for (int i = 0; i < wet; ++i) surface = water_surface(ray, water_m);
  distance_m = min(distance_m, water_m);
#endif
  // Where there is no ground a clear sky still ends at the planet.
  float end_m = sky_kind() == sky_clear ? min(distance_m, planet_m) : distance_m;
  vec3 radiance;
  float direct_share = 0.0;
  if (end_m < no_hit_m) {
    Air air = air_to(ray.direction, end_m);
    vec3 direct = surface.direct * air.transmittance;
    radiance = direct + surface.diffuse * air.transmittance + air.in_scatter;
    direct_share = dot(direct, vec3(1.0)) / max(dot(radiance, vec3(1.0)), 1.0e-30);
  } else {
    radiance = radiance_above(ray.direction);
  }
  return PassOutput(vec4(min(radiance * frame.accumulation.z, vec3(frame.accumulation.y)), direct_share), vec4(distance_m));
}
