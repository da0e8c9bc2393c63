// targets: rgba32f rgba32f
// The sky of a camera between two levels, from the tables of both.
#include "shared/sky_block.glsl"
layout(binding = 0) uniform sampler2D lower_even;
layout(binding = 1) uniform sampler2D upper_even;
layout(binding = 2) uniform sampler2D lower_aerosol;
layout(binding = 3) uniform sampler2D upper_aerosol;

PassOutput shade(ivec2 pixel) {
  return PassOutput(mix(texelFetch(lower_even, pixel, 0), texelFetch(upper_even, pixel, 0), sky.level.y),
                    mix(texelFetch(lower_aerosol, pixel, 0), texelFetch(upper_aerosol, pixel, 0), sky.level.y));
}
