// Where rays meet shapes. Intervals are (near, far) in metres along a ray of unit direction; near > far means no hit.
#ifndef LIB_INTERSECT
#define LIB_INTERSECT
#include "lib/constants.glsl"

// A ball about `center`.
vec2 intersect_sphere(vec3 origin, vec3 direction, vec3 center, float radius_m) {
  vec3 o = origin - center;
  float b = dot(o, direction);
  vec3 closest = o - b * direction;
  float h2 = radius_m * radius_m - dot(closest, closest);
  if (h2 < 0.0) return vec2(1.0, -1.0);
  float h = sqrt(h2);
  return vec2(-b - h, -b + h);
}

vec2 intersect_slab(float origin, float direction, float low, float high) {
  if (abs(direction) < 1.0e-7) return origin >= low && origin <= high ? vec2(-no_hit_m, no_hit_m) : vec2(1.0, -1.0);
  float a = (low - origin) / direction;
  float b = (high - origin) / direction;
  return vec2(min(a, b), max(a, b));
}

vec2 intersect_box(vec3 origin, vec3 direction, vec3 low, vec3 high) {
  vec2 x = intersect_slab(origin.x, direction.x, low.x, high.x);
  vec2 y = intersect_slab(origin.y, direction.y, low.y, high.y);
  vec2 z = intersect_slab(origin.z, direction.z, low.z, high.z);
  return vec2(max(max(x.x, y.x), z.x), min(min(x.y, y.y), z.y));
}

// The surface of altitude `surface_altitude_m` about the planet. `origin` is relative to the point at sea level below the
// camera (so origin.z is close to the altitude). The products are arranged so that 32 bits keep centimetres near the surface:
// with q = r^2 - (R + s)^2 = x^2 + y^2 + (z - s)(z + s + 2 R).
vec2 intersect_altitude(vec3 origin, vec3 direction, float surface_altitude_m) {
  float q = origin.x * origin.x + origin.y * origin.y +
            (origin.z - surface_altitude_m) * (origin.z + surface_altitude_m + 2.0 * planet_radius_m);
  float b = origin.x * direction.x + origin.y * direction.y + (origin.z + planet_radius_m) * direction.z;
  float discriminant = b * b - q;
  if (discriminant < 0.0) return vec2(1.0, -1.0);
  float root = sqrt(discriminant);
  float s = b > 0.0 ? -b - root : -b + root;  // the root without cancellation
  if (s == 0.0) return vec2(0.0, 0.0);
  return vec2(min(s, q / s), max(s, q / s));
}

// Altitude of a point given relative to the sea-level point below the camera; exact to a metre within 200 km.
float altitude_of(vec3 position) {
  return position.z + (position.x * position.x + position.y * position.y) / (2.0 * (planet_radius_m + position.z));
}

// The same at any distance, to some metres.
float altitude_far_of(vec3 position) {
  float z = position.z + planet_radius_m;
  return sqrt(position.x * position.x + position.y * position.y + z * z) - planet_radius_m;
}
#endif
