// What glows, and how much of it (Olajos 2.7).
#ifndef LIB_BLOOM
#define LIB_BLOOM
#include "lib/display.glsl"

// The part of the radiance that lies above the threshold of luminance, in its own hue. Radiance beyond 1e25 counts as 1e25, so
// that sums over a picture stay finite.
vec3 bloom_excess(vec3 radiance, float threshold) {
  vec3 bounded = min(radiance, vec3(1.0e25));
  return bounded * max(0.0, 1.0 - threshold / max(luminance(bounded), 1.0e-30));
}

// Bound of the glowing light: exposed luminance times area, with the picture's height as the unit of length. tuned: the sun's disc
// at noon is 20,000 times brighter than a cloud and has about 5 in a picture 50 degrees high; it must not flood the picture, and
// what a clear view of it, a rim of it at a cloud's edge and its disc between a few coarse pixels add must differ little.
const float bloom_bound = 0.4;

// What each glowing light is multiplied with, where all of it together is `total`: 1 for little, and never more than the bound in
// all. One factor for the whole picture, and not a bound for each pixel: it keeps the shape of the glow, and does not depend on how
// many pixels the sun covers.
float bloom_scale(float total) { return 1.0 / (1.0 + total / bloom_bound); }

// How much of the interval [low, high] lies in pixel i, [i, i + 1].
float pixel_overlap(int i, float low, float high) { return max(0.0, min(high, float(i) + 1.0) - max(low, float(i))); }
#endif
