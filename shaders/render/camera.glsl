// The world-space ray of a pixel.
#ifndef RENDER_CAMERA
#define RENDER_CAMERA
#include "shared/frame_block.glsl"
#include "lib/lens.glsl"

struct CameraRay {
  vec3 origin;  // relative to the point at sea level below the camera, m
  vec3 direction;
  float valid;
};

// `pixel` in pixels of the whole picture; the subpixel jitter of the sample is added here.
CameraRay camera_ray(vec2 pixel) {
  LensRay ray = lens_ray(frame.size.z, pixel + frame.lens.zw, vec2(frame.size.xy), frame.lens.x, frame.lens.y);
  mat3 world_from_view = mat3(frame.camera_right.xyz, frame.camera_up.xyz, frame.camera_forward.xyz);
  return CameraRay(world_from_view * ray.origin + vec3(0.0, 0.0, frame.camera_forward.w), world_from_view * ray.direction,
                   ray.valid);
}
#endif
