// targets: rgba16f r32f
// The scene of a document with a terrain: a program of its own, so that others do not pay for it.
#define WITH_TERRAIN
#include "render/scene.glsl"
