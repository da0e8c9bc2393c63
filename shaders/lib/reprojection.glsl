// Places in a perspective picture (0..1 each, y down) and view space (x right, y up, z forward).
#ifndef LIB_REPROJECTION
#define LIB_REPROJECTION

// The ray through a place, where z is 1. `half_height`: tangent of half the vertical field of view; `aspect`: width over height.
vec3 view_ray(vec2 place, float half_height, float aspect) {
  return vec3((2.0 * place.x - 1.0) * half_height * aspect, (1.0 - 2.0 * place.y) * half_height, 1.0);
}

// Where a point (or a direction) of view space is seen; z: 1 in the picture, 0 outside it or behind the camera.
vec3 place_of_view(vec3 seen, float half_height, float aspect) {
  float scale = 0.5 / (max(seen.z, 1.0e-9) * half_height);
  float x = 0.5 + seen.x * scale / aspect;
  float y = 0.5 - seen.y * scale;
  bool inside = seen.z > 0.0 && x >= 0.0 && x <= 1.0 && y >= 0.0 && y <= 1.0;
  return vec3(x, y, inside ? 1.0 : 0.0);
}
#endif
