// Looking up the in-scatter volume (server/bake/in_scatter.h): the light at a point that is not the sun's own beam.
#ifndef RENDER_IN_SCATTER
#define RENDER_IN_SCATTER
#include "render/medium.glsl"
#include "lib/phase.glsl"
layout(binding = 11) uniform sampler3D in_scatter_mean;      // mean radiance; share of the sun's beam that arrives
layout(binding = 12) uniform sampler3D in_scatter_directed;  // mean of radiance times direction, in mean radiances

// Where p lies in the volume's textures. `jitter` (0..1) chooses between the two levels whose thresholds lie about that of p.
vec3 in_scatter_place(vec3 p, Land land, float jitter) {
  vec3 place = (p - cloud.box_low.xyz) / (cloud.box_high.xyz - cloud.box_low.xyz);
  if (is_textured()) place = vec3(p.xy * cloud.tile.xy + cloud.tile.zw + land.shift, height_in_layer(p));
  vec3 at = place * cloud.in_scatter_scale.xyz + cloud.in_scatter_offset.xyz;
  float levels = cloud.in_scatter_scale.w;
  float level = (land.threshold - cloud.in_scatter_levels.x) * cloud.in_scatter_levels.y;
  level = is_textured() ? clamp(floor(level + jitter), 0.0, levels - 1.0) : 0.0;
  float half_texel = 0.5 * levels / float(textureSize(in_scatter_mean, 0).z);
  return vec3(at.xy, (level + clamp(at.z, half_texel, 1.0 - half_texel)) / levels);
}

// Radiance scattered along `direction` by a medium that scatters all it takes, and the share of the sun's beam that arrives on the
// grid. The light comes from all directions by a function with the moments that were solved, of Henyey and Greenstein's kind, which
// is nowhere negative; scattering turns its mean cosine by that of the phase function.
vec4 in_scattered(vec3 place, vec3 direction) {
  vec4 mean = textureLod(in_scatter_mean, place, 0.0);
  vec3 directed = textureLod(in_scatter_directed, place, 0.0).xyz;
  float size = length(directed);
  float cosine = dot(directed, direction) / max(size, 1.0e-6);
  float lobe = phase_henyey_greenstein(cosine, cloud.in_scatter_offset.w * min(size, 0.98)) / phase_isotropic;
  return vec4(mean.xyz * lobe, mean.w);
}
#endif
