// targets: rgba8
// A kept picture in display values.
#include "render/shown.glsl"
layout(binding = 0) uniform sampler2D kept_radiance;

PassOutput shade(ivec2 pixel) { return PassOutput(shown(texelFetch(kept_radiance, pixel, 0).xyz, pixel)); }
