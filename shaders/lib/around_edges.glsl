// A texel or cell less than a size outside a texture or lattice that repeats, inside it: without a division, which software does one by one.
#ifndef LIB_AROUND_EDGES
#define LIB_AROUND_EDGES
ivec3 around_edges(ivec3 texel, ivec3 size) {
  return texel + size * (ivec3(lessThan(texel, ivec3(0))) - ivec3(greaterThanEqual(texel, size)));
}
#endif
