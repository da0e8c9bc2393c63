// targets: rgba16f
// Table of the atmosphere's transmittance to space by altitude and direction (Hillaire 2020, section 4).
#include "shared/frame_block.glsl"
#include "lib/atmosphere.glsl"
#include "lib/sky_mapping.glsl"

PassOutput shade(ivec2 pixel) {
  vec2 parameter = table_parameter(vec2(pixel), vec2(64.0));
  float altitude_m = transmittance_altitude_m(parameter.y);
  return PassOutput(vec4(transmittance_to_space(altitude_m, transmittance_mu(parameter.x), frame.atmosphere.x, 48), 1.0));
}
