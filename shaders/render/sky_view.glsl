// targets: rgba32f rgba32f
// Table of the clear sky's radiance above the horizon, as a camera at one altitude sees it (Hillaire 2020, section 5.3). Target 0: all
// but the aerosol's first order of the main light. Target 1: that, before its phase function.
#include "shared/sky_block.glsl"
#include "render/air_light.glsl"

const int sky_view_steps = 24;  // tuned: twice as many change no channel by a hundredth

PassOutput shade(ivec2 pixel) {
  float altitude_m = sky.level.x;
  vec2 parameter = table_parameter(vec2(pixel), sky_view_size);
  float sine = sky_view_sine(parameter.y, horizon_sine(altitude_m));
  vec2 azimuth = to_world_azimuth(azimuth_direction(parameter.x, mirrored_sky()));
  vec3 direction = vec3(sqrt(max(0.0, 1.0 - sine * sine)) * azimuth, sine);
  vec2 air = intersect_altitude(vec3(0.0, 0.0, altitude_m), direction, atmosphere_top_m);
  if (air.x > air.y || air.y <= 0.0) return PassOutput(vec4(0.0), vec4(0.0));
  AirMarch march = march_air(altitude_m, direction, max(air.x, 0.0), air.y, sky_view_steps);
  return PassOutput(vec4(march.even, 1.0), vec4(march.aerosol, 1.0));
}
