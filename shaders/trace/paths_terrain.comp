// The path tracer with mountains, which cost each ray a walk over their cells.
layout(local_size_x = 64) in;
#include "trace/surface_terrain.glsl"
#include "trace/air_tables.glsl"
#include "trace/paths.glsl"
