// targets: rgba32f
// Table of the light's irradiance in the cloud layer: across, how far towards the light (as the sine of the angle at the planet's
// middle), upwards the height in the layer. Near sunset the light changes within a kilometre of height, and the planet's shadow moves
// up through the clouds.
#include "shared/cloud_block.glsl"
#include "render/air.glsl"

PassOutput shade(ivec2 pixel) {
  vec2 parameter = table_parameter(vec2(pixel), cloud_sun_size);
  float altitude_m = mix(cloud.layer.x, cloud.layer.y, parameter.y);
  float mu = clamp(frame.light_direction.z + cloud_sun_span * (2.0 * parameter.x - 1.0), -1.0, 1.0);
  vec3 arrives = int(frame.sky.w) == 2 ? light_transmittance(max(altitude_m, 0.0), mu, frame.light_direction.w) : vec3(1.0);
  return PassOutput(vec4(frame.light_irradiance.xyz * arrives, 1.0));
}
