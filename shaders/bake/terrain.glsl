// targets: r32f
// Heights of a mountain range from seeded noise, in no unit (server/bake scales them); the map tiles. Warped ridges give the
// ranges and broad valleys; gullies that follow the slope, octave upon octave each along the slope of what lies above it, carve
// them as water does (after the idea of erosion noise: Johansen 2025, "Phacelle noise"; clayjohn 2018).
#include "shared/terrain_bake_block.glsl"
#include "lib/relief.glsl"

// Ranges of several sizes: height and its slope per cell of the largest.
vec3 ranges(vec2 p, int cells, uint seed) {
  vec2 shift = vec2(relief_noise(p + 0.37, cells, seed).x, relief_noise(p + 0.71, cells, seed + 1u).x);
  vec2 q = p + 0.3 * shift;
  vec3 broad = relief_noise(q, cells, seed + 2u);
  vec3 crest = relief_ridges(relief_noise(q + 0.25, cells, seed + 3u), 0.045);
  vec3 spur = relief_ridges(relief_noise(2.0 * q, 2 * cells, seed + 4u), 0.03);
  vec3 rough = relief_noise(4.0 * q, 4 * cells, seed + 5u);
  float high = clamp(0.5 + 0.9 * broad.x, 0.0, 1.0);  // where mountains are, and where the land is low
  vec3 mountains = crest * 0.6 + (0.45 * clamp(crest.x, 0.0, 1.0)) * vec3(spur.x, 2.0 * spur.y, 2.0 * spur.z);
  vec3 height = vec3(0.6 * broad.x, 0.6 * broad.y, 0.6 * broad.z) + mountains * high;
  return height + 0.08 * vec3(rough.x, 4.0 * rough.y, 4.0 * rough.z) * (0.3 + high);
}

// Where the slope points down; any direction where it is level.
vec2 down_of(vec2 slope) { return dot(slope, slope) > 1.0e-8 ? -normalize(slope) : vec2(1.0, 0.0); }

PassOutput shade(ivec2 pixel) {
  int cells = terrain_bake.noise.x;
  uint seed = terrain_bake.seed.x * 64u;
  vec2 p = vec2(pixel) / float(terrain_bake.noise.z) * float(cells);
  vec3 land = ranges(p, cells, seed);
  // tuned: as deep as a gully of that width is on a real slope; more looks like crumpled paper.
  float depth = 0.13 * terrain_bake.shape.y;
  float fine = 0.012;
  int frequency = 4;
  for (int octave = 0; octave < terrain_bake.noise.y; ++octave) {
    if (4 * frequency * cells > terrain_bake.noise.z) break;  // narrower than the lattice can hold
    float f = float(frequency);
    vec2 slope = vec2(land.y, land.z);
    float steep = smoothstep(0.0, 1.2, length(slope));
    vec3 gullies = relief_gullies(f * p, down_of(slope), frequency * cells, seed + 8u + uint(octave));
    vec3 rocks = relief_noise(f * p, frequency * cells, seed + 24u + uint(octave));
    land += (depth * steep) * vec3(gullies.x, f * gullies.y, f * gullies.z) +
            (fine * (0.15 + steep)) * vec3(rocks.x, f * rocks.y, f * rocks.z);
    depth *= terrain_bake.shape.x;
    fine *= terrain_bake.shape.x;
    frequency *= 2;
  }
  return PassOutput(vec4(land.x));
}
