// What water reflects: the sky as it is above the water, clouds from a panorama of them (server/render/water_stage.h), and the land.
#ifndef RENDER_WATER_REFLECTION
#define RENDER_WATER_REFLECTION
#include "shared/water_block.glsl"
#include "render/terrain.glsl"
#include "lib/water.glsl"
layout(binding = 0) uniform sampler2D water_sky_table;
layout(binding = 1) uniform sampler2D water_sky_aerosol_table;
layout(binding = 2) uniform sampler2D water_clouds;

const int land_steps = 16;

// `sine`: of the direction's elevation above the water, not negative.
vec3 sky_over_water(vec3 direction, float sine) {
  if (sky_kind() != sky_clear) return sky_kind() == sky_uniform ? frame.sky.xyz : vec3(0.0);
  vec2 azimuth = from_light_azimuth(direction.xy);
  vec2 uv = table_uv(vec2(azimuth_coordinate(azimuth.x, azimuth.y, mirrored_sky()), sky_view_v(sine, horizon_sine(water.surface.x))),
                     sky_view_size);
  float phase = phase_cornette_shanks(dot(direction, frame.light_direction.xyz), frame.aerosol.x);
  return textureLod(water_sky_table, uv, 0.0).xyz + phase * textureLod(water_sky_aerosol_table, uv, 0.0).xyz + frame.night.xyz;
}

// Radiance and transmittance of the clouds that are seen from a place on the water, averaged over `spread` (radians). The panorama
// was taken elsewhere: the ray is followed to the clouds' altitude, and that point is looked up.
vec4 clouds_over_water(vec3 place, vec3 direction, float sine, float spread) {
  if (water.clouds.w < 0.0) return vec4(0.0, 0.0, 0.0, 1.0);
  float high_m = water.clouds.z;
  float reach_m = 2.0 * high_m / (sine + sqrt(sine * sine + 2.0 * high_m / planet_radius_m) + 1.0e-6);
  // tuned: so far from where it was taken the panorama is looked up as if it were taken here, without its detail.
  vec2 away = place.xy - water.clouds.xy;
  float stay = smoothstep(10.0 * high_m, 40.0 * high_m, length(away));
  vec2 to_m = reach_m * direction.xy + (1.0 - stay) * away;
  float far_m = max(length(to_m), 1.0e-3 * high_m);
  float elevation = atan(high_m / far_m - far_m / (2.0 * planet_radius_m));
  vec2 size = vec2(textureSize(water_clouds, 0));
  float level = clamp(log2(max(spread * size.x / (2.0 * pi), 1.0)), stay * water.clouds.w, water.clouds.w);
  float v = clamp(1.0 - 2.0 * elevation / pi, 0.0, 1.0);
  return textureLod(water_clouds, vec2(0.5 + atan(to_m.x, to_m.y) / (2.0 * pi), v), level);
}

int land_level(float spacing_m) {
  return clamp(int(log2(max(spacing_m * terrain.lattice.x, 1.0))), 0, min(3, terrain.size.y));
}
vec2 land_point(vec2 place, int level) { return (terrain.lattice.zw + place * terrain.lattice.x) / float(1 << level); }

float land_altitude_m(vec2 place, int level) {
  if (!on_the_map(place)) return terrain.altitude.x;
  vec2 at = land_point(place, level);
  return terrain.altitude.x + height_in_cell(cell_corners(ivec2(floor(at)), level), fract(at));
}

// How far the land is, m, and its share of a reflection that is blurred by `spread` (radians).
struct LandAhead {
  float distance_m, share;
};

// By a march over the height map of as many steps as Felix Westin's ("Approximating water effects using terrain height maps"), which are
// 750 m at grazing angles and 300 m looking down, for mountains of about 1500 m. tuned: ours grow with the distance. Of all points the
// one that stands highest above the ray counts: by its angle the blurred reflection is cut off.
LandAhead land_ahead(vec3 place, vec3 direction, float sine, float cosine, float spread) {
  float relief_m = max(terrain.altitude.y - water.surface.x, 1.0);
  float reach_m = min(float(land_steps) * mix(0.5, 0.2, cosine) * relief_m, relief_m / max(sine, 0.02));
  float previous_m = 0.0;
  float previous_clear_m = 1.0;
  float highest = -1.0;
  LandAhead ahead = LandAhead(no_hit_m, 0.0);
  for (int i = 1; i <= land_steps; ++i) {
    float share = float(i) / float(land_steps);
    float t = reach_m * share * sqrt(share);
    vec3 p = place + direction * t;
    int level = land_level(0.5 * (t - previous_m));
    float altitude_m = altitude_of(p);
    float clear_m = altitude_m - terrain.altitude.x - lattice_point(ivec2(floor(land_point(p.xy, level))), level).y;
    int near = clear_m < spread * t ? 1 : 0;  // the highest point of the cell
    for (int k = 0; k < near; ++k) clear_m = altitude_m - land_altitude_m(p.xy, level);
    float angle = -clear_m / t;
    bool enters = clear_m < 0.0 && previous_clear_m >= 0.0 && highest < 0.0;
    if (enters) ahead.distance_m = mix(previous_m, t, previous_clear_m / (previous_clear_m - clear_m));
    else if (angle > highest && highest < 0.0) ahead.distance_m = t;
    highest = max(highest, angle);
    if (highest > spread) break;
    previous_m = t;
    previous_clear_m = clear_m;
  }
  ahead.share = smoothstep(-spread, spread, highest);
  return ahead;
}

// Share of the sun's disc above the land (its shadows fall on the water: render/terrain_sun.glsl).
float sun_above_land(vec3 place, vec3 up) {
  float share = 1.0;
  int land = frame.ground.x == 2.0 ? 1 : 0;
  for (int i = 0; i < land; ++i) {
    Site site;
    site.position = place, site.up = up;
    site.uv = (terrain.lattice.zw + place.xy * terrain.lattice.x + 0.5) / float(terrain.size.x);
    share = sun_share(site);
  }
  return share;
}

// As site_at and cover_at have it, without stones, fields and grain, which waves would blur: they are most of the cost.
Site mirrored_site(vec3 position, float width_m) {
  Site site;
  site.position = position, site.width_m = width_m, site.grain = 0.0;
  site.altitude_m = altitude_of(position);
  site.up = normalize(vec3(position.xy / planet_radius_m, 1.0));
  site.uv = (terrain.lattice.zw + position.xy * terrain.lattice.x + 0.5) / float(terrain.size.x);
  vec4 land = textureLod(terrain_surface, site.uv, log2(max(1.0, 1.5 * width_m * terrain.lattice.x)));
  if (!on_the_map(position.xy)) land = vec4(0.0, 0.0, 1.0, 0.0);
  site.sky = land.z, site.stands_out = land.w, site.steepness = length(land.xy);
  site.normal = normalize(vec3(site.up.xy - land.xy, 1.0));
  return site;
}

vec3 mirrored_cover(Site site) {
  float high = site.altitude_m - terrain.cover.x;
  float tree_line_m = terrain.cover.y + 250.0 * site.stands_out;
  vec3 heath = vec3(0.6, 0.5, 0.4) * (terrain.rock.xyz + 0.6 * frame.ground_albedo.xyz);
  vec3 soil = mix(frame.ground_albedo.xyz, heath, smoothstep(tree_line_m - 250.0, tree_line_m + 350.0, site.altitude_m));
  vec3 rock = terrain.rock.xyz * (1.0 + 0.3 * site.stands_out);
  float snow = smoothstep(-350.0, 350.0, high - 300.0 * site.stands_out);
  snow *= 1.0 - smoothstep(1.25 * terrain.cover.z, 1.9 * terrain.cover.z, site.steepness - 0.0003 * high);
  vec3 ground = mix(soil, rock, smoothstep(0.8 * terrain.cover.z, 1.15 * terrain.cover.z, site.steepness));
  return clamp(mix(ground, terrain.snow.xyz, snow), 0.0, 1.0);
}

// `behind`: radiance of the sky there, of which the air before the land has its part. `distance_m`: from the camera to the water.
vec3 land_over_water(vec3 place, vec3 direction, float land_m, float distance_m, vec3 behind) {
  Site site = mirrored_site(place + direction * land_m, pixel_width_m(distance_m + land_m));
  Surface land = lit_land(site, mirrored_cover(site));
  vec3 through = sky_kind() == sky_clear ? exp(-air_at(water.surface.x, frame_atmosphere()).extinction * land_m) : vec3(1.0);
  return mix(behind, land.direct + land.diffuse, through);
}

// All of it, from where the mirror looks.
vec3 reflected_radiance(vec3 place, vec3 up, float cosine, float distance_m, Mirrored mirror) {
  float below = min(0.0, dot(mirror.direction, up));
  vec3 direction = mirror.direction - 2.0 * below * up;
  float sine = dot(direction, up);
  float spread = max(mirror.spread, 0.004);
  vec3 sky = sky_over_water(direction, sine);
  vec4 clouds = clouds_over_water(place, direction, sine, spread);
  vec3 radiance = sky * clouds.w + clouds.xyz;
  int land = frame.ground.x == 2.0 ? 1 : 0;
  for (int i = 0; i < land; ++i) {
    LandAhead ahead = land_ahead(place, direction, sine, cosine, spread);
    int seen = ahead.share > 0.0 ? 1 : 0;
    for (int k = 0; k < seen; ++k)
      radiance = mix(radiance, land_over_water(place, direction, ahead.distance_m, distance_m, sky), ahead.share);
  }
  return radiance;
}
#endif
