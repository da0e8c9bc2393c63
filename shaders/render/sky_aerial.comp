// Table of the air between a camera at one altitude and a point, by azimuth, elevation and distance: light scattered in (all but the
// aerosol's first order; that, before its phase function), and transmittance; three blocks one above the other. One invocation
// goes along one direction. The air goes on below sea level, so that nothing jumps at the horizon.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 1) in;
layout(binding = 0, rgba32f) uniform writeonly image3D target;
#include "shared/sky_block.glsl"
#include "render/air_light.glsl"

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  int slices = int(aerial_size.z);
  if (texel.x >= int(aerial_size.x) || texel.y >= int(aerial_size.y) || texel.z > volume_pass.z_begin) return;
  vec2 parameter = table_parameter(vec2(texel.xy), aerial_size.xy);
  float sine = aerial_sine(parameter.y, horizon_sine(sky.level.x));
  vec2 azimuth = to_world_azimuth(azimuth_direction(parameter.x, mirrored_sky()));
  vec3 direction = vec3(sqrt(max(0.0, 1.0 - sine * sine)) * azimuth, sine);
  vec3 origin = vec3(0.0, 0.0, sky.level.x);
  vec2 air = intersect_altitude(origin, direction, atmosphere_top_m);
  float entry_m = sky.level.x > atmosphere_top_m && air.x <= air.y ? max(air.x, 0.0) : 0.0;
  float begin_m = max(entry_m, aerial_begin_m(sky.level.x, direction));
  AirMarch march = march_air(sky.level.x, direction, entry_m, begin_m, begin_m > entry_m ? 12 : 0);
  float previous_m = 0.0;
  for (int slice = 0; slice < slices; ++slice) {
    float next_m = aerial_distance_m(float(slice) / float(slices - 1));
    for (int i = 0; i < 2; ++i) {
      float step_m = 0.5 * (next_m - previous_m);
      vec3 p = origin + direction * (begin_m + previous_m + (float(i) + 0.5) * step_m);
      march = air_step(march, p, direction, step_m);
    }
    previous_m = next_m;
    imageStore(target, ivec3(texel.xy, slice), vec4(march.even, 1.0));
    imageStore(target, ivec3(texel.xy, slice + slices), vec4(march.aerosol, 1.0));
    imageStore(target, ivec3(texel.xy, slice + 2 * slices), vec4(march.transmittance, 1.0));
  }
}
