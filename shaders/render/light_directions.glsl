// The directions by which sky and ground light the clouds, even in solid angle, and the parts of the sky that they fall in.
#ifndef RENDER_LIGHT_DIRECTIONS
#define RENDER_LIGHT_DIRECTIONS
#include "render/air.glsl"

const int light_elevations = 8;
const int light_azimuths = 16;

vec3 light_direction_of(int index) {
  float z = (float(index / light_azimuths) + 0.5) * 2.0 / float(light_elevations) - 1.0;
  float azimuth = 2.0 * pi * (float(index % light_azimuths) + 0.5) / float(light_azimuths);
  return vec3(sqrt(1.0 - z * z) * to_world_azimuth(vec2(cos(azimuth), sin(azimuth))), z);
}

// Parts: 0 above 30 degrees; 1 to 4 a band above the horizon, towards the light, to its left, away from it, to its right; 5 below.
int light_part_of(int index) {
  int row = index / light_azimuths;
  if (row < light_elevations / 2) return 5;
  if (row >= light_elevations * 3 / 4) return 0;
  return 1 + (index + light_azimuths / 8) / (light_azimuths / 4) % 4;
}
#endif
