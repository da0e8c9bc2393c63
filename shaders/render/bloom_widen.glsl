// targets: rgba32f
// A level that has no Gaussian of its own: the coarser one, interpolated. Doubling the size step by step with a linear filter is
// Chaikin's subdivision: it tends to a smooth spline, without the creases of one linear interpolation.
#include "shared/bloom_block.glsl"
layout(binding = 0) uniform sampler2D coarser;

PassOutput shade(ivec2 texel) { return PassOutput(vec4(texture(coarser, (vec2(texel) + 0.5) / vec2(bloom.size.xy)).xyz, 0.0)); }
