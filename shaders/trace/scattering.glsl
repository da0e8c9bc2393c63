// Directions drawn from the document's phase function, and its value between two directions.
//
// Of `mie` each colour has a function of its own. A path draws all its directions by the function of one colour, chosen evenly when
// it begins, and stands for all three: weighted by how likely each of them was to draw it (the balance heuristic over the whole path;
// Wilkie et al. 2014, "Hero Wavelength Spectral Sampling"), so that no colour's weight exceeds 3 however long the path.
#ifndef TRACE_SCATTERING
#define TRACE_SCATTERING
#include "shared/cloud_block.glsl"
#include "lib/phase.glsl"
#include "lib/sampling.glsl"
#include "trace/state.glsl"
layout(binding = 5) uniform sampler2D phase_texels;   // of mie: 1/sr by colour (server/bake/phase_sampling.h)
layout(binding = 3) uniform sampler2D phase_aliases;  // rows 0..2: of each colour; row 3: densities of the cells by colour, 1/sr

const int traced_phase_two_lobe = 1;
const int traced_phase_rayleigh = 2;
const int traced_phase_mie = 4;
int phase_kind() { return int(cloud.medium.w); }

// Of mie at a place in the table, 0..1, linear between texels.
vec3 phase_in_table(float coordinate) {
  int cells = textureSize(phase_texels, 0).x - 1;
  float at = coordinate * float(cells);
  int below = clamp(int(at), 0, cells - 1);
  return mix(texelFetch(phase_texels, ivec2(below, 0), 0).xyz, texelFetch(phase_texels, ivec2(below + 1, 0), 0).xyz,
             at - float(below));
}

// 1/sr by colour, of light that comes against `sun` (unit, towards it) scattered against `direction`.
vec3 phase_value(vec3 direction, vec3 sun) {
  if (phase_kind() == traced_phase_mie)
    return phase_in_table(phase_table_coordinate(length(direction - sun), length(direction + sun)));
  return vec3(phase_of_kind(phase_kind(), dot(direction, sun), cloud.phase.x, cloud.phase.y, cloud.phase.z, 1.0));
}

// A direction that was drawn: what it multiplies the throughput by, and how likely each colour's function was to draw it beside
// the one that did.
struct Scattered {
  vec3 direction, weight, likelihood;
};

// The cosine of the functions with closed forms.
float drawn_cosine(float u, float lobe) {
  if (phase_kind() == traced_phase_rayleigh) return sample_rayleigh(u);
  if (phase_kind() > traced_phase_rayleigh) return 1.0 - 2.0 * u;
  bool second = phase_kind() == traced_phase_two_lobe && lobe < cloud.phase.z;
  return sample_henyey_greenstein(second ? cloud.phase.y : cloud.phase.x, u);
}

// Walker's alias method (1977) for the cell, evenly by solid angle in it; the function's course within the cell is a weight.
Scattered scattered_by_table(vec3 direction) {
  vec3 u = random_numbers();
  vec3 v = random_numbers();
  int cells = textureSize(phase_aliases, 0).x;
  int cell = min(int(u.x * float(cells)), cells - 1);
  vec4 alias = texelFetch(phase_aliases, ivec2(cell, int(path.colour)), 0);
  if (u.y >= alias.x) cell = int(alias.y);
  float begin = phase_table_haversine(float(cell) / float(cells));
  float end = phase_table_haversine(float(cell + 1) / float(cells));
  float haversine = mix(begin, end, v.x);
  vec3 density = texelFetch(phase_aliases, ivec2(cell, 3), 0).xyz;
  float drawn = path.colour == 0u ? density.x : path.colour == 1u ? density.y : density.z;
  float forward = pow(haversine / max(1.0 - haversine, 1.0e-12), 0.25);
  vec3 value = phase_in_table(forward / (1.0 + forward));
  return Scattered(direction_about(direction, haversine, v.y), value / drawn, density / drawn);
}

Scattered scattered_from(vec3 direction) {
  if (phase_kind() == traced_phase_mie) return scattered_by_table(direction);
  vec3 u = random_numbers();
  return Scattered(direction_about(direction, 0.5 - 0.5 * drawn_cosine(u.x, u.z), u.y), vec3(1.0), vec3(1.0));
}
#endif
