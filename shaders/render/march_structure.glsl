// targets: rgba16f rg32f
// The march by the thesis' structure: a program of its own, so that others do not pay for it.
#define THESIS_STRUCTURE
#include "render/march.glsl"
