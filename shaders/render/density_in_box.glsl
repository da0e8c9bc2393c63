// Density where a point may be outside the volume.
#ifndef RENDER_DENSITY_IN_BOX
#define RENDER_DENSITY_IN_BOX
#include "render/medium.glsl"

float density_in_box(vec3 p) {
  bool outside = any(lessThan(p, cloud.box_low.xyz)) || any(greaterThan(p, cloud.box_high.xyz));
  if (volume_kind() == volume_sphere) outside = outside || distance(p, box_center()) > sphere_radius_m();
  return outside ? 0.0 : density_at(p);
}
#endif
