// The path tracer through clouds and air above a plain ground, or none.
layout(local_size_x = 64) in;
#include "trace/surface_plain.glsl"
#include "trace/air_traced.glsl"
#include "trace/paths.glsl"
