// Looking up the in-scatter volume (server/bake/in_scatter.h): the light at a point that is not the sun's own beam.
#ifndef RENDER_IN_SCATTER
#define RENDER_IN_SCATTER
#include "render/medium.glsl"
#include "lib/phase.glsl"
layout(binding = 11) uniform sampler3D in_scatter_mean;      // mean radiance; share of the sun's beam that arrives
layout(binding = 12) uniform sampler3D in_scatter_directed;  // mean of radiance times direction, in mean radiances

// Where p lies in the volume's textures at its lower level; how far on the next one is, and its share. The light was solved among
// clouds that lean (in_scatter_extinction.comp), so that it is where they are.
struct InScatterPlace {
  vec3 at;
  float next, share;
};

InScatterPlace in_scatter_place(vec3 p, Land land) {
  vec3 place = (p - cloud.box_low.xyz) / (cloud.box_high.xyz - cloud.box_low.xyz);
  if (is_textured()) place = vec3(p.xy * cloud.tile.xy + cloud.tile.zw + land.shift, height_in_layer(p));
  vec3 at = place * cloud.in_scatter_scale.xyz + cloud.in_scatter_offset.xyz;
  float levels = cloud.in_scatter_scale.w;
  vec2 level = light_level(land);
  float half_texel = 0.5 * levels / float(textureSize(in_scatter_mean, 0).z);
  return InScatterPlace(vec3(at.xy, (level.x + clamp(at.z, half_texel, 1.0 - half_texel)) / levels), 1.0 / levels, level.y);
}

// Of a volume's texture, between the levels about the place.
vec4 between_levels(sampler3D volume, InScatterPlace place) {
  int count = cloud.in_scatter_scale.w > 1.0 ? 2 : 1;  // a loop, which software goes through as often as it must
  vec4 sum = vec4(0.0);
  for (int i = 0; i < count; ++i) {
    float share = i == 0 ? 1.0 - place.share : place.share;
    sum += share * textureLod(volume, place.at + vec3(0.0, 0.0, float(i) * place.next), 0.0);
  }
  return sum;
}

const float darkest_depth = 9.2;  // the grid's beam ends there (server/bake/in_scatter_beam.cpp)

// Optical depth towards the sun where this share of the grid's beam arrives: without what is scattered into the forward peak.
float depth_on_grid(float beam) { return -log(max(beam, exp(-darkest_depth))); }
float far_optical_depth(InScatterPlace place) {
  return depth_on_grid(between_levels(in_scatter_mean, place).w) / (1.0 - cloud.in_scatter_levels.z);
}

// Light along `direction` over the mean of all directions, once a medium of mean cosine g has scattered it: light whose mean cosine about
// its own axis was `size`, and `cosine` is that of `direction` about it. Up to the second Legendre moment, which is none for light
// from a hemisphere (size 1/2) and below, that of a Lambert surface's at 2/3, and 1 for a beam. tuned: three quarters of it by Henyey
// and Greenstein's function, all of it for a beam: slabs want the one (tests/gpu/render/in_scatter_test.cpp), broken clouds the other.
float scattered_lobe(float cosine, float size, float g) {
  float second = g * g * max(0.0, 2.0 * size - 1.0) * size;
  float even = max(0.0, 1.0 + 3.0 * g * size * cosine + 5.0 * second * (1.5 * cosine * cosine - 0.5));
  float beam = phase_henyey_greenstein(cosine, g * min(size, 0.98)) / phase_isotropic;
  return mix(even, beam, mix(0.75, 1.0, smoothstep(0.6, 1.0, size)));
}

// Radiance scattered along `direction` by a medium that scatters all it takes, and the share of the sun's beam that arrives on the grid.
vec4 in_scattered(InScatterPlace place, vec3 direction) {
  vec4 mean = between_levels(in_scatter_mean, place);
  vec3 directed = between_levels(in_scatter_directed, place).xyz;
  float size = length(directed);
  float lobe = scattered_lobe(dot(directed, direction) / max(size, 1.0e-6), size, cloud.in_scatter_offset.w);
  return vec4(mean.xyz * lobe, mean.w);
}
#endif
