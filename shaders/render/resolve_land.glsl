// targets: rgba16f r32f
// The kept picture where there is land, whose outlines are told apart.
#define OUTLINES
#include "render/resolve.glsl"
