// A plain ground at sea level, a sea, or none.
#ifndef TRACE_SURFACE_PLAIN
#define TRACE_SURFACE_PLAIN
#include "trace/surface.glsl"
#include "lib/ground.glsl"

float surface_distance_m(vec3 origin, vec3 direction) {
  const float ground_plain = 1.0;
  vec2 hit = intersect_altitude(origin, direction, max(frame.water.w, 0.0));
  return frame.ground.x == ground_plain && hit.x <= hit.y && hit.y > 0.0 ? max(hit.x, 0.0) : no_hit_m;
}

Reflector surface_at(vec3 origin, vec3 direction, float distance_m, bool first) {
  vec3 p = origin + direction * distance_m;
  float pixel_angle = frame.size.z == 0 ? 2.0 * frame.lens.x / float(frame.size.y) : 2.0 / float(frame.size.y);
  float footprint_m = first ? distance_m * pixel_angle / max(0.02, abs(direction.z)) : 20.0;
  vec3 tint = ground_tint(p.xy + frame.ground.yz, footprint_m, frame.ground_albedo.w);
  return Reflector(clamp(frame.ground_albedo.xyz * tint, 0.0, 1.0), up_at(p));
}
#endif
