// Camera, sky, sun and ground of one frame (server/render fills it). Binding 1. Positions are metres relative to the point at
// sea level below the camera, so that 32 bits suffice anywhere in the world.
#ifndef SHARED_FRAME_BLOCK
#define SHARED_FRAME_BLOCK
#include "shared/block.glsl"

/* camera_right, camera_up, camera_forward: world directions; camera_forward.w: camera altitude, m.
   lens: tangent of half the vertical field of view, orthographic width (m), subpixel jitter x, y.
   size: width, height, lens kind, march divisor. sample_info: index of the sample, layers of stars, lights, dither?
   sun_direction: towards the sun, square of the chord of its angular radius. sun_irradiance: above the atmosphere, 1 / solid angle or 0.
   light_direction: towards what lights clouds and ground, sun or moon, its radius (radians). light_irradiance: above the atmosphere, 0.
   second_direction, second_irradiance: of the other one, which lights only the air; used where lights is 2.
   moon_direction: towards the moon, square of the chord of its radius, 0: not to be seen. moon_lit_from: towards the sun, from the moon.
   moon_radiance: of its lit part. star_x, star_y, star_z: axes of the star sphere; star_x.w: radius of a star's image (radians).
   stars: irradiance of magnitude 0 (rgb), 0. night: radiance of the air's own glow (rgb), 0.
   sky: radiance of a uniform sky, kind as core's SkyKind. atmosphere: factors on air, aerosol, ozone, scale height of the aerosol (m).
   aerosol: asymmetry, 0, 0, 0.
   ground_albedo: rgb, variation. ground: kind, fields' offset east and north (m), 0.
   water: albedo as of a diffuse surface, altitude (m; below the planet: there is none).
   display: 2^exposure, tone curve, strength and threshold (exposed luminance) of the bloom.
   accumulation: weight of the new sample, greatest radiance that the targets hold, what radiance is multiplied by in them,
   side of what a pixel's sample stands for (pixels). march_target: column and row of the first ray in the targets, whether only
   pixels that are newly seen are asked for, 0. */
#define FRAME_FIELDS(F) \
  F(vec4, camera_right) \
  F(vec4, camera_up) \
  F(vec4, camera_forward) \
  F(vec4, lens) \
  F(ivec4, size) \
  F(ivec4, sample_info) \
  F(vec4, sun_direction) \
  F(vec4, sun_irradiance) \
  F(vec4, light_direction) \
  F(vec4, light_irradiance) \
  F(vec4, second_direction) \
  F(vec4, second_irradiance) \
  F(vec4, moon_direction) \
  F(vec4, moon_lit_from) \
  F(vec4, moon_radiance) \
  F(vec4, star_x) \
  F(vec4, star_y) \
  F(vec4, star_z) \
  F(vec4, stars) \
  F(vec4, night) \
  F(vec4, sky) \
  F(vec4, atmosphere) \
  F(vec4, aerosol) \
  F(vec4, ground_albedo) \
  F(vec4, ground) \
  F(vec4, water) \
  F(vec4, display) \
  F(vec4, accumulation) \
  F(ivec4, march_target)
DECLARE_BLOCK(FrameBlock, frame, 1, FRAME_FIELDS)
#endif
