// The permutation that lib/perlin.glsl asks for: Perlin's own for seed 0, a seeded shuffle else; made by server/bake.
#ifndef BAKE_PERMUTATION
#define BAKE_PERMUTATION
layout(binding = 0) uniform sampler2D permutation_table;  // 256x1
int permutation(int index) { return int(texelFetch(permutation_table, ivec2(index, 0), 0).x); }
#endif
