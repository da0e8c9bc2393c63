// Shares of the light above, beside and below (the parts of render/light_directions.glsl: above 30 degrees, from there to the horizon,
// and below it) that come to points of the clouds' tile through the cloud between, scattered on the way or not.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "render/cloud_grid.glsl"
#include "render/slab.glsl"
layout(binding = 0, rgba32f) uniform writeonly image3D target;

// tuned: twice as many of either change the light by some hundredths. Steps grow with the distance: near cloud matters most.
const int azimuths = 4;
const float most_steps = 8.0;

float transmitted(GridPoint point, vec3 direction) {
  float end = direction.z > 0.0 ? sun_grid.levels.w : sun_grid.levels.z;
  float end_m = (end - point.place.z) / (cloud.layer.z * direction.z);
  end_m = min(end_m, within_tile(point.place, direction).y);
  float steps = clamp(ceil(cells_between(point.place, place_towards(point.place, direction, end_m))), 1.0, most_steps);
  float sum = 0.0;
  for (float i = 0.5; i < steps; ++i) {
    float share = i / steps;
    sum += 2.0 * share * grid_density(place_towards(point.place, direction, end_m * share * share), point.level);
  }
  return slab_transmittance(cloud.medium.x * sum * end_m / steps);
}

// Mean over the azimuths, of which the first is turned by this share of what is between two.
float transmitted_at(GridPoint point, float sine, float turned) {
  float cosine = sqrt(1.0 - sine * sine), sum = 0.0;
  for (int i = 0; i < azimuths; ++i) {
    float azimuth = 2.0 * pi * (float(i) + turned) / float(azimuths);
    sum += transmitted(point, vec3(cosine * cos(azimuth), cosine * sin(azimuth), sine));
  }
  return sum / float(azimuths);
}

// The sines are those of the means of halves of a part; but the horizon is at its brightest low down, where most cloud stands in its
// way. tuned: lower ones bring dusk nearer to the path-traced reference, and take an even sky away from it.
void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);
  if (!is_in_grid(texel, imageSize(target))) return;
  GridPoint point = grid_point(texel, imageSize(target));
  float above = transmitted_at(point, 0.75, 0.5);
  float beside = 0.5 * (transmitted_at(point, 0.05, 0.0) + transmitted_at(point, 0.25, 0.5));
  float below = 0.5 * (transmitted_at(point, -0.25, 0.5) + transmitted_at(point, -0.75, 0.0));
  imageStore(target, texel, vec4(above, beside, below, 0.0));
}
