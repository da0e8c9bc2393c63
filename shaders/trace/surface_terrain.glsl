// Mountains, and the plain or the water around them. Water is a diffuse surface here: it lights what is above it, but mirrors nothing.
#ifndef TRACE_SURFACE_TERRAIN
#define TRACE_SURFACE_TERRAIN
#include "trace/surface.glsl"
#include "render/terrain.glsl"

float water_distance_m(vec3 origin, vec3 direction) {
  vec2 hit = intersect_altitude(origin, direction, frame.water.w);
  return frame.water.w >= 0.0 && hit.x <= hit.y && hit.y > 0.0 ? max(hit.x, 0.0) : no_hit_m;
}

float surface_distance_m(vec3 origin, vec3 direction) {
  return min(land_distance_m(CameraRay(origin, direction, 1.0)), water_distance_m(origin, direction));
}

Reflector surface_at(vec3 origin, vec3 direction, float distance_m, bool first) {
  if (water_distance_m(origin, direction) <= distance_m) return Reflector(frame.water.xyz, up_at(origin + direction * distance_m));
  Site site = site_at(CameraRay(origin, direction, 1.0), distance_m);
  return Reflector(clamp(cover_at(site), 0.0, 1.0), site.normal);
}
#endif
