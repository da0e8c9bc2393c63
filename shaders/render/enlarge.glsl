// targets: rgba8
// The part of a kept picture that is shown, as large as it was asked for. Display values are what is interpolated: the tone curve costs
// as many pixels as are kept, and an edge against something bright stays an edge without steps.
#include "shared/resolve_block.glsl"
layout(binding = 0) uniform sampler2D developed;

PassOutput shade(ivec2 pixel) {
  vec2 place = ((vec2(pixel) + 0.5) / float(resolve.kept.w) + resolve.marched.zw) / vec2(resolve.kept.xy);
  return PassOutput(textureLod(developed, place, 0.0));
}
