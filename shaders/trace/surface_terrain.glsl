// Mountains, and the plain around them.
#ifndef TRACE_SURFACE_TERRAIN
#define TRACE_SURFACE_TERRAIN
#include "trace/surface.glsl"
#include "render/terrain.glsl"

float surface_distance_m(vec3 origin, vec3 direction) { return land_distance_m(CameraRay(origin, direction, 1.0)); }

Reflector surface_at(vec3 origin, vec3 direction, float distance_m, bool first) {
  Site site = site_at(CameraRay(origin, direction, 1.0), distance_m);
  return Reflector(clamp(cover_at(site), 0.0, 1.0), site.normal);
}
#endif
