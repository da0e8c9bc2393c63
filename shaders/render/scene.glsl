// targets: rgba16f r32f
// The scene without clouds: sky, sun's disc, curved ground or terrain. Target 0: radiance, and the share of it that is direct sunlight (so
// that cloud shadows can be taken off later). Target 1: distance along the ray, m; no_hit_m for sky.
#include "render/camera.glsl"
#include "render/terrain.glsl"

const float ground_terrain = 2.0;

// By the chord: the cosine of a small angle has too few digits in 32 bits.
vec3 sun_disc(vec3 direction) {
  vec3 chord = direction - frame.sun_direction.xyz;
  if (dot(chord, chord) > frame.sun_direction.w || frame.sun_irradiance.w <= 0.0) return vec3(0.0);
  vec3 through = sky_kind() == sky_clear ? space_transmittance(camera_altitude_m(), direction.z) : vec3(1.0);
  return frame.sun_irradiance.xyz * frame.sun_irradiance.w * through;
}

PassOutput ground(CameraRay ray, float distance_m) {
  vec3 p = ray.origin + ray.direction * distance_m;
  float pixel_angle = frame.size.z == 0 ? 2.0 * frame.lens.x / float(frame.size.y) : 2.0 / float(frame.size.y);
  float footprint_m = distance_m * pixel_angle / max(0.02, abs(ray.direction.z));
  vec3 albedo = frame.ground_albedo.xyz * ground_tint(p.xy + frame.ground.yz, footprint_m, frame.ground_albedo.w);
  vec3 direct = albedo / pi * sun_irradiance_at_ground();
  vec3 diffuse = albedo / pi * sky_irradiance();
  Air air = air_to(ray.direction, distance_m, 0.0);
  vec3 radiance = (direct + diffuse) * air.transmittance + air.in_scatter;
  float direct_share = dot(direct * air.transmittance, vec3(1.0)) / max(dot(radiance, vec3(1.0)), 1.0e-6);
  return PassOutput(vec4(radiance, direct_share), vec4(distance_m));
}

PassOutput shade(ivec2 pixel) {
  CameraRay ray = camera_ray(vec2(pixel) + 0.5);
  if (ray.valid == 0.0) return PassOutput(vec4(0.0), vec4(0.0));
  if (frame.ground.x == ground_terrain) {
    float distance_m = land_distance_m(ray);
    if (distance_m < no_hit_m) return PassOutput(terrain_radiance(ray, distance_m), vec4(distance_m));
  }
  vec2 hit = intersect_altitude(ray.origin, ray.direction, 0.0);
  if (frame.ground.x == 1.0 && hit.x <= hit.y && hit.y > 0.0) return ground(ray, max(hit.x, 0.0));
  vec3 radiance = sky_radiance(ray.direction) + sun_disc(ray.direction);
  return PassOutput(vec4(min(radiance, vec3(frame.accumulation.y)), 0.0), vec4(no_hit_m));
}
