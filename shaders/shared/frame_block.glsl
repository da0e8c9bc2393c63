// Camera, sky, sun and ground of one frame (server/render fills it). Binding 1. Positions are metres relative to the point at
// sea level below the camera, so that 32 bits suffice anywhere in the world.
#ifndef SHARED_FRAME_BLOCK
#define SHARED_FRAME_BLOCK
#include "shared/block.glsl"

/* camera_right, camera_up, camera_forward: world directions; camera_forward.w: camera altitude, m.
   lens: tangent of half the vertical field of view, orthographic width (m), subpixel jitter x, y.
   size: width, height, lens kind, march divisor. sample_info: index of the sample, 0, 0, dither?
   sun_direction: towards the sun, square of the chord of its angular radius. sun_irradiance: above the atmosphere, 1 / solid angle or 0.
   sky: radiance of a uniform sky, kind as core's SkyKind. atmosphere: haze, unused...
   ground_albedo: rgb, variation. ground: kind, fields' offset east and north (m), 0.
   display: 2^exposure, tone curve, strength and threshold (exposed luminance) of the bloom.
   accumulation: weight of the new sample, greatest radiance that the targets hold, 0, 0. */
#define FRAME_FIELDS(F) \
  F(vec4, camera_right) \
  F(vec4, camera_up) \
  F(vec4, camera_forward) \
  F(vec4, lens) \
  F(ivec4, size) \
  F(ivec4, sample_info) \
  F(vec4, sun_direction) \
  F(vec4, sun_irradiance) \
  F(vec4, sky) \
  F(vec4, atmosphere) \
  F(vec4, ground_albedo) \
  F(vec4, ground) \
  F(vec4, display) \
  F(vec4, accumulation)
DECLARE_BLOCK(FrameBlock, frame, 1, FRAME_FIELDS)
#endif
