// The ray of a pixel for each lens, in view space: x right, y up, z forward. Pixel coordinates grow right and down.
#ifndef LIB_LENS
#define LIB_LENS
#include "lib/constants.glsl"

struct LensRay {
  vec3 origin;     // m, relative to the camera; zero but for the orthographic lens
  vec3 direction;  // unit
  float valid;     // 0 outside the circle of the fisheye
};

// 0 where the picture stays black: outside the circle of the fisheye.
float lens_shows(int kind, vec2 pixel, vec2 size_px) {
  vec2 q = (2.0 * pixel - size_px) / min(size_px.x, size_px.y);
  return kind == 3 && dot(q, q) > 1.0 ? 0.0 : 1.0;
}

// kind as core's LensKind. `pixel` is a position in the picture, (0.5, 0.5) the middle of the top left pixel; `half_height` is
// the tangent of half the vertical field of view (perspective), `width_m` the picture's width (orthographic).
LensRay lens_ray(int kind, vec2 pixel, vec2 size_px, float half_height, float width_m) {
  vec2 p = vec2(2.0 * pixel.x / size_px.x - 1.0, 1.0 - 2.0 * pixel.y / size_px.y);  // -1..1, up positive
  float aspect = size_px.x / size_px.y;
  LensRay ray = LensRay(vec3(0.0), vec3(0.0, 0.0, 1.0), 1.0);
  if (kind == 0) {
    ray.direction = normalize(vec3(p.x * aspect * half_height, p.y * half_height, 1.0));
  } else if (kind == 1) {
    ray.origin = vec3(0.5 * width_m * p.x, 0.5 * width_m * p.y / aspect, 0.0);
  } else if (kind == 2) {
    float azimuth = pi * p.x;
    float elevation = 0.5 * pi * p.y;
    ray.direction = vec3(sin(azimuth) * cos(elevation), sin(elevation), cos(azimuth) * cos(elevation));
  } else {
    float smaller = min(size_px.x, size_px.y);
    vec2 q = vec2(p.x * size_px.x / smaller, p.y * size_px.y / smaller);
    float angle = 0.5 * pi * length(q);
    float side = length(q) > 0.0 ? sin(angle) / length(q) : 0.0;
    ray.direction = vec3(q.x * side, q.y * side, cos(angle));
    ray.valid = length(q) <= 1.0 ? 1.0 : 0.0;
  }
  return ray;
}
#endif
