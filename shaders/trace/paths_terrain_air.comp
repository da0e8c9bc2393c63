// The path tracer through clouds and air with mountains.
layout(local_size_x = 64) in;
#include "trace/surface_terrain.glsl"
#include "trace/air_traced.glsl"
#include "trace/paths.glsl"
