// The phase function that is looked up (server/bake/phase_table.h), once a ray.
#ifndef RENDER_PHASE_TABLE
#define RENDER_PHASE_TABLE
#include "lib/phase.glsl"
layout(binding = 5) uniform sampler2D phase_table;

const int phase_mie = 4;  // as core's PhaseKind

// Red, green and blue, 1/sr, of light from `sun` (unit, towards it) scattered against `direction` (unit, of the view ray).
vec3 mie_phase(vec3 direction, vec3 sun) {
  float cells = float(textureSize(phase_table, 0).x - 1);
  float coordinate = phase_table_coordinate(length(direction - sun), length(direction + sun));
  return textureLod(phase_table, vec2((coordinate * cells + 0.5) / (cells + 1.0), 0.5), 0.0).xyz;
}
#endif
