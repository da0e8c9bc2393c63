// Clouds before a scene.
#ifndef RENDER_CLOUDS_BEFORE
#define RENDER_CLOUDS_BEFORE
#include "shared/frame_block.glsl"

// Radiance, 1 - transmittance of the clouds. `scene`: radiance and the share of it that is direct sunlight; `march`: radiance and
// transmittance; `sunlit`: share of the sunlight that reaches what is behind.
vec4 clouds_before(vec4 scene, vec4 march, float sunlit) {
  vec3 lit = scene.xyz * (1.0 - scene.w * (1.0 - sunlit));
  // What the clouds' shadow takes from the air can be more than a neighbour's air has.
  return vec4(max(lit * march.w + march.xyz, vec3(0.0)) / frame.accumulation.z, 1.0 - march.w);
}

// Distance of what is seen, m.
float seen_at_m(float opacity, float cloud_m, float scene_m) { return opacity >= 0.5 ? min(cloud_m, scene_m) : scene_m; }
#endif
