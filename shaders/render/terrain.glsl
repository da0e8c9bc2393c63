// What a view ray sees of a terrain: rock where it is steep, snow high up, meadows and woods below; sun with the shadows of the
// land, and a sky that the land around hides in part.
#ifndef RENDER_TERRAIN
#define RENDER_TERRAIN
#include "render/terrain_hit.glsl"
#include "render/sky.glsl"
#include "lib/ground.glsl"
layout(binding = 12) uniform sampler2D terrain_surface;
layout(binding = 13) uniform sampler2D terrain_sun;

// Light that a surface sends to the camera: of the sun (or the moon), and of the sky.
struct Surface {
  vec3 direct, diffuse;
};

struct Site {
  vec3 position;     // relative to the point below the camera, m
  vec3 up, normal;   // of the planet, of the land
  float altitude_m, width_m;  // of what a pixel covers
  float sky, stands_out, steepness, grain;
  vec2 uv;
};

bool on_the_map(vec2 p) {
  return terrain.size.z == 1 ||
         (all(greaterThanEqual(p, terrain.box.xy)) && all(lessThanEqual(p, terrain.box.zw)));
}

// The same land, smaller and turned: rocks and blocks that the lattice is too coarse for. `turn` is a whole number of times as
// small either way, so that it tiles as the land does. Its mean slope is 0: it fades out as pixels grow wider than it is.
vec4 small_land(vec2 points, vec2 turn, float width_m) {
  float level = log2(max(1.0, width_m * terrain.lattice.x * length(turn)));
  vec2 turned = vec2(turn.x * points.x - turn.y * points.y, turn.y * points.x + turn.x * points.y);
  return textureLod(terrain_surface, turned / float(terrain.size.x), level);
}

Site site_at(CameraRay ray, float distance_m) {
  Site site;
  site.position = ray.origin + ray.direction * distance_m;
  site.altitude_m = altitude_of(site.position);
  site.up = normalize(vec3(site.position.xy / planet_radius_m, 1.0));
  site.width_m = pixel_width_m(distance_m);
  vec2 points = terrain.lattice.zw + site.position.xy * terrain.lattice.x;
  site.uv = (points + 0.5) / float(terrain.size.x);
  vec4 land = vec4(0.0, 0.0, 1.0, 0.0);
  vec2 rocks = vec2(0.0);
  site.grain = 0.0;
  if (on_the_map(site.position.xy)) {
    // tuned: a pixel on a slope seen at a grazing angle covers more; twice its width is between sharp and still.
    float level = log2(max(1.0, 1.5 * site.width_m * terrain.lattice.x));
    land = textureLod(terrain_surface, site.uv, level);
    vec4 blocks = small_land(points, vec2(5.0, 4.0), site.width_m);
    vec4 stones = small_land(points, vec2(-13.0, 19.0), site.width_m);
    float rough = clamp(1.4 * length(land.xy) - 0.15, 0.08, 0.9);  // tuned: screes and meadows are smoother than walls
    rocks = rough * (0.3 * blocks.xy + 0.35 * stones.xy);
    site.grain = 0.7 * (blocks.w + stones.w);
  }
  site.sky = land.z;
  site.stands_out = land.w;
  site.steepness = length(land.xy + 0.6 * rocks);
  site.normal = normalize(vec3(-(land.xy + rocks) + site.up.xy, 1.0));
  return site;
}

vec3 cover_at(Site site) {
  // tuned, all of it: to look at.
  float high = site.altitude_m - terrain.cover.x;
  vec3 green = frame.ground_albedo.xyz *
               ground_tint(site.position.xy + frame.ground.yz, site.width_m, frame.ground_albedo.w) * (1.0 + 0.25 * site.grain);
  vec3 heath = vec3(0.6, 0.5, 0.4) * (terrain.rock.xyz + 0.6 * frame.ground_albedo.xyz);
  float tree_line_m = terrain.cover.y + 160.0 * site.grain + 250.0 * site.stands_out;
  vec3 soil = mix(green, heath, smoothstep(tree_line_m - 250.0, tree_line_m + 350.0, site.altitude_m));
  vec3 rock = terrain.rock.xyz * (1.0 + 0.35 * site.grain + 0.3 * site.stands_out);
  float bare = smoothstep(0.8 * terrain.cover.z, 1.15 * terrain.cover.z, site.steepness + 0.12 * site.grain);
  float snow = smoothstep(-350.0, 350.0, high + 200.0 * site.grain - 300.0 * site.stands_out);
  snow *= 1.0 - smoothstep(1.25 * terrain.cover.z, 1.9 * terrain.cover.z, site.steepness + 0.1 * site.grain - 0.0003 * high);
  return mix(mix(soil, rock, bare), terrain.snow.xyz, snow);
}

// Share of the sun's disc above the land.
float sun_share(Site site) {
  float sine = clamp(dot(site.up, frame.light_direction.xyz), -1.0, 1.0);
  float land = on_the_map(site.position.xy) ? atan(texture(terrain_sun, site.uv).x) : -0.2;
  return smoothstep(-terrain.sun.z, terrain.sun.z, asin(sine) - land);
}

vec3 sunlight_at(Site site) {
  vec3 irradiance = light_at(site.altitude_m, dot(site.up, frame.light_direction.xyz));
  return irradiance * sun_share(site) * max(0.0, dot(site.normal, frame.light_direction.xyz));
}

Surface lit_land(Site site, vec3 albedo) {
  vec3 direct = albedo / pi * sunlight_at(site);
  vec3 around = albedo * sky_irradiance() * 0.5 + pi * ground_radiance() * 0.5;  // the slopes opposite
  vec3 diffuse = albedo / pi * mix(around, sky_irradiance() * (0.6 + 0.4 * site.normal.z), site.sky);
  return Surface(direct, diffuse);
}

Surface terrain_surface_at(CameraRay ray, float distance_m) {
  Site site = site_at(ray, distance_m);
  return lit_land(site, clamp(cover_at(site), 0.0, 1.0));
}

// Distance to the land or to the plain around it, m; no_hit_m where there is neither.
float land_distance_m(CameraRay ray) {
  vec2 stretch = terrain_stretch(ray.origin, ray.direction);
  float distance_m = stretch.x < stretch.y ? terrain_distance_m(ray.origin, ray.direction) : no_hit_m;
  if (distance_m < no_hit_m) return distance_m;
  float plain_m = terrain.size.z == 1 ? terrain.altitude.z : terrain.altitude.x;
  vec2 plain = intersect_altitude(ray.origin, ray.direction, plain_m);
  return plain.x <= plain.y && plain.y > 0.0 ? max(plain.x, 0.0) : no_hit_m;
}
#endif
