// targets: rgba32f
// Table of the colours that light clouds and ground (render/sky.glsl reads them): 0 the sky's irradiance on level ground, 1 radiance of
// the ground in the sun, 2 to 7 mean radiance of the
// parts of the sphere about a cloud (render/light_directions.glsl), 8 that of the last part if no cloud shaded the ground.
#include "shared/cloud_block.glsl"
#include "render/light_directions.glsl"
layout(binding = 0) uniform sampler2D rays_air;
layout(binding = 1) uniform sampler2D rays_ground;

const int sky_none = 0;
const int sky_uniform = 1;

vec3 sky_from(int index, int row) {
  int kind = int(frame.sky.w);
  if (kind == sky_none) return vec3(0.0);
  return kind == sky_uniform ? frame.sky.xyz : texelFetch(rays_air, ivec2(index, row), 0).xyz + frame.night.xyz;
}

vec3 level_irradiance() {
  vec3 sum = vec3(0.0);
  for (int i = light_elevations / 2 * light_azimuths; i < light_elevations * light_azimuths; ++i)
    sum += sky_from(i, 0) * light_direction_of(i).z;
  return sum * (4.0 * pi / float(light_elevations * light_azimuths));
}

vec3 sun_on_ground() {
  float mu = frame.light_direction.z;
  vec3 arrives = int(frame.sky.w) == 2 ? light_transmittance(0.0, mu, frame.light_direction.w) : vec3(1.0);
  return frame.light_irradiance.xyz * arrives * max(mu, 0.0);
}

// `shade`: share of the light that the clouds take from it.
vec3 ground_radiance_under(float shade) {
  if (frame.ground.x <= 0.0) return vec3(0.0);
  return frame.ground_albedo.xyz / pi * (sun_on_ground() + level_irradiance()) * (1.0 - shade);
}

vec3 mean_of_part(int part, float shade) {
  vec3 ground = part == 5 ? ground_radiance_under(shade) : vec3(0.0);
  bool clear = int(frame.sky.w) == 2;
  vec3 sum = vec3(0.0);
  float count = 0.0;
  for (int i = 0; i < light_elevations * light_azimuths; ++i) {
    if (light_part_of(i) != part) continue;
    vec3 before = texelFetch(rays_ground, ivec2(i, 1), 0).xyz;
    bool below = part == 5 && frame.ground.x > 0.0;
    sum += clear ? sky_from(i, 1) + before * ground : (below ? ground : sky_from(i, 1));
    ++count;
  }
  return sum / max(count, 1.0);
}

PassOutput shade(ivec2 pixel) {
  if (pixel.x == 0) return PassOutput(vec4(level_irradiance(), 1.0));
  if (pixel.x == 1) return PassOutput(vec4(ground_radiance_under(0.0), 1.0));
  if (pixel.x == 8) return PassOutput(vec4(mean_of_part(5, 0.0), 1.0));
  // tuned: of the light on a cumulus two thirds do not come through.
  return PassOutput(vec4(mean_of_part(pixel.x - 2, 0.67 * cloud.volume.z), 1.0));
}
