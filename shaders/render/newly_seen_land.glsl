// targets: rgba16f r32f
// What is newly seen where there is land, whose outlines are told apart.
#define OUTLINES
#include "render/newly_seen.glsl"
