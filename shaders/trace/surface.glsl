// The ground as paths meet it; how far it is and what it is like is said by surface_plain.glsl or surface_terrain.glsl.
#ifndef TRACE_SURFACE
#define TRACE_SURFACE
#include "shared/frame_block.glsl"
#include "render/camera.glsl"
#include "render/sky.glsl"

struct Reflector {
  vec3 albedo, normal;
};

// The vertical, all round the planet.
vec3 up_at(vec3 p) { return normalize(vec3(p.xy, p.z + planet_radius_m)); }

// Distance to the ground along a ray, m; no_hit_m where there is none.
float surface_distance_m(vec3 origin, vec3 direction);

// As the scene without clouds shows it to the camera (`first`); to others what is finer than a house is averaged.
Reflector surface_at(vec3 origin, vec3 direction, float distance_m, bool first);
#endif
