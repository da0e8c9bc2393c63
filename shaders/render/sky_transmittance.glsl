// targets: rgba32f
// Table of the atmosphere's transmittance to space by altitude and direction (Hillaire 2020, section 4).
#include "render/air.glsl"

PassOutput shade(ivec2 pixel) {
  vec2 parameter = table_parameter(vec2(pixel), transmittance_size);
  float altitude_m = transmittance_altitude_m(parameter.y);
  return PassOutput(vec4(transmittance_to_space(altitude_m, transmittance_mu(parameter.x, altitude_m), frame_atmosphere(), 64), 1.0));
}
