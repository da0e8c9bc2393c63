// The path tracer above a plain ground, or none.
layout(local_size_x = 64) in;
#include "trace/surface_plain.glsl"
#include "trace/air_tables.glsl"
#include "trace/paths.glsl"
