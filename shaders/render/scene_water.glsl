// targets: rgba16f r32f
// The scene of a document with water: a program of its own, so that others do not pay for it.
#define WITH_TERRAIN
#define WITH_WATER
#include "render/scene.glsl"
