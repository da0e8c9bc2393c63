// What a view ray sees of water: the sky, clouds and land in its waves, the sun's glitter, and what comes out of the water.
#ifndef RENDER_WATER
#define RENDER_WATER
#include "render/water_reflection.glsl"

float water_distance_m(CameraRay ray) {
  vec2 hit = intersect_altitude(ray.origin, ray.direction, water.surface.x);
  return hit.x <= hit.y && hit.y > 0.0 ? max(hit.x, 0.0) : no_hit_m;
}

// Bends the trains, so that their sum does not show how few they are. tuned: over half a kilometre, 60 m and 15 m, by up to a quarter
// each; repeats as the ground does.
vec2 wander_m(vec2 place) {
  vec2 p = place * (2.0 * pi / 65536.0);
  vec2 wide = vec2(sin(97.0 * p.x + 41.0 * p.y) + sin(150.0 * p.y - 31.0 * p.x), sin(109.0 * p.y - 53.0 * p.x) + sin(161.0 * p.x + 29.0 * p.y));
  vec2 narrow = vec2(sin(1009.0 * p.x + 433.0 * p.y), sin(1171.0 * p.y - 389.0 * p.x));
  vec2 fine = vec2(sin(3917.0 * p.y + 1733.0 * p.x), sin(4391.0 * p.x - 1481.0 * p.y));
  return 7.0 * wide + 2.2 * narrow + 0.55 * fine;
}

// Four trains of waves, if the picture can show them (add_waves); else they are roughness.
Waves more_waves(Waves waves, mat4 trains, Footprint footprint) {
  float slope = water.body.w;
  int shown = footprint.across_m * trains[2].x < 6.0 ? 1 : 0;
  for (int i = 0; i < shown; ++i) waves = add_waves(waves, trains, slope, footprint);
  waves.unseen_mss += 2.0 * slope * slope * float(1 - shown);
  return waves;
}

Waves waves_in(Footprint footprint) {
  Waves waves = Waves(vec2(0.0), water.surface.y, wander_m(footprint.middle_m + frame.ground.yz));
  waves = more_waves(waves, water.waves_a, footprint);
  waves = more_waves(waves, water.waves_b, footprint);
  waves = more_waves(waves, water.waves_c, footprint);
  waves = more_waves(waves, water.waves_d, footprint);
  waves = more_waves(waves, water.waves_e, footprint);
  return more_waves(waves, water.waves_f, footprint);
}

// Gusts and slicks, 1 on average: what the eye sees of a sea from high up. tuned: to look at.
float gusts_at(vec2 place, float width_m) {
  vec2 p = place + frame.ground.yz;
  float wide = ground_noise(p, 4096.0, 11u) - 0.5;
  float narrow = (ground_noise(p, 512.0, 12u) - 0.5) * pattern_contrast(512.0, width_m);
  return 1.0 + 0.5 * wide + 0.5 * narrow;
}

// Albedo of what lies in and under the water; w: how much of a surface there is, which ends at the shore.
vec4 water_body(vec3 place, float width_m, float cosine) {
  vec4 body = vec4(water.body.xyz, 1.0);
  int land = frame.ground.x == 2.0 ? 1 : 0;
  for (int i = 0; i < land; ++i) {
    float depth_m = max(water.surface.x - land_altitude_m(place.xy, land_level(width_m)), 0.0);
    // tuned: as water takes of red, green and blue beside each other (Pope and Fry 1997), weakened for what is in it.
    vec3 faded = exp(-depth_m * (1.0 + 1.0 / water_refracted(cosine)) * water.surface.w * vec3(2.2, 1.0, 0.9));
    body = vec4(mix(body.xyz, 0.8 * terrain.rock.xyz, faded), smoothstep(0.0, 0.4, depth_m));
  }
  return body;
}

Surface water_surface(CameraRay ray, float distance_m) {
  vec3 place = ray.origin + ray.direction * distance_m;
  vec3 up = normalize(vec3(place.xy, place.z + planet_radius_m));
  vec3 view = -ray.direction;
  float cosine = clamp(dot(view, up), 1.0e-4, 1.0);
  float width_m = water.view.x + water.view.y * distance_m;
  vec2 along = ray.direction.xy / max(length(ray.direction.xy), 1.0e-6);
  Waves waves = waves_in(Footprint(place.xy, along, width_m / cosine, width_m));
  // The sun's disc is as wide as slopes of an eighth of its radius squared make it.
  float radius = frame.light_direction.w;
  float mss = waves.unseen_mss * gusts_at(place.xy, width_m) + 0.125 * radius * radius;
  // Of a wave that turns away from the camera one sees the edge.
  vec3 normal = normalize(up - vec3(waves.slope, 0.0));
  normal = normalize(normal + max(0.0, 0.3 * cosine - dot(normal, view)) * view);
  Mirrored mirror = water_mirror(view, normal, mss);
  vec4 body = water_body(place, width_m, cosine);
  float mu = dot(up, frame.light_direction.xyz);
  vec3 sun = light_at(water.surface.x, mu) * sun_above_land(place, up);
  vec3 albedo = body.xyz * (1.0 - mirror.share * body.w);
  float glitter = body.w * water_glitter(view, frame.light_direction.xyz, normal, mss);
  int glitters = glitter > 1.0e-4 ? 1 : 0;
  for (int i = 0; i < glitters; ++i) glitter *= clouds_over_water(place, frame.light_direction.xyz, max(mu, 0.0), 0.0).w;
  vec3 direct = sun * (albedo / pi * max(mu, 0.0) + glitter);
  vec3 reflected = reflected_radiance(place, up, cosine, distance_m, mirror);
  return Surface(direct, body.w * mirror.share * reflected + albedo / pi * sky_irradiance());
}
#endif
