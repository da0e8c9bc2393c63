// targets: rgba32f
// Table of six colours that light clouds and ground (render/sky.glsl reads them): the sky's mean radiance, its irradiance on
// level ground, sunlight at the bottom and top of the clouds and at the ground, and the ground's radiance.
#include "shared/cloud_block.glsl"
#include "render/sky.glsl"

const int azimuths = 8;
const int elevations = 8;

// cosine_weighted: irradiance on level ground; else the mean over the hemisphere.
vec3 hemisphere(bool cosine_weighted) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < elevations; ++i) {
    float z = (float(i) + 0.5) / float(elevations);  // even in solid angle
    float horizontal = sqrt(1.0 - z * z);
    for (int k = 0; k < azimuths; ++k) {
      float azimuth = 2.0 * pi * (float(k) + 0.5) / float(azimuths);
      vec3 direction = vec3(horizontal * cos(azimuth), horizontal * sin(azimuth), z);
      sum += sky_radiance(direction) * (cosine_weighted ? 2.0 * pi * z : 1.0);
    }
  }
  return sum / float(azimuths * elevations);
}

// The planet's rotundity: from `altitude_m` the sun is seen down to the dip of the horizon.
vec3 sun_at(float altitude_m) {
  if (sky_kind() != sky_clear) return frame.sun_irradiance.xyz;
  return frame.sun_irradiance.xyz * space_transmittance(altitude_m, frame.sun_direction.z);
}

PassOutput shade(ivec2 pixel) {
  vec3 value = vec3(0.0);
  if (pixel.x == 0) value = hemisphere(false);
  if (pixel.x == 1) value = hemisphere(true);
  if (pixel.x == 2) value = sun_at(cloud.layer.x);
  if (pixel.x == 3) value = sun_at(cloud.layer.y);
  if (pixel.x == 4) value = sun_at(0.0) * max(frame.sun_direction.z, 0.0);
  if (pixel.x == 5 && frame.ground.x > 0.0)
    value = frame.ground_albedo.xyz / pi * (sun_at(0.0) * max(frame.sun_direction.z, 0.0) + hemisphere(true));
  return PassOutput(vec4(value, 1.0));
}
