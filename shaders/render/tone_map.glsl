// targets: rgba8
// A picture without bloom as it is displayed.
#include "render/shown.glsl"
layout(binding = 0) uniform sampler2D radiance;

PassOutput shade(ivec2 pixel) { return PassOutput(shown(texelFetch(radiance, pixel, 0).xyz, pixel)); }
