// Random directions and distances from random numbers in [0, 1): what a path tracer draws (Pharr, Jakob, Humphreys 2016, chapter 13).
#ifndef LIB_SAMPLING
#define LIB_SAMPLING
#include "lib/constants.glsl"

// Optical depth to the next collision: exponentially distributed. Half a step of the 24 bits that random numbers have keeps it finite.
float sample_optical_depth(float u) { return -log(1.0 - u - 0.5 / 16777216.0); }

// The cosine between a unit vector and a random one, distributed as the Henyey-Greenstein phase function (Henyey and Greenstein
// 1941; inverted by Witt 1977).
float sample_henyey_greenstein(float g, float u) {
  if (abs(g) < 1.0e-4) return 1.0 - 2.0 * u;  // even to 0.03 %, and the formula has no digits left
  float s = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
  return clamp((1.0 + g * g - s * s) / (2.0 * g), -1.0, 1.0);
}

// The same for the Rayleigh phase function: the real root of mu^3 + 3 mu = 8 u - 4 (Frisvad 2011, eq. 9).
float sample_rayleigh(float u) {
  float a = 4.0 * u - 2.0;
  float root = pow(abs(a) + sqrt(a * a + 1.0), 1.0 / 3.0);
  float cosine = root - 1.0 / root;
  return clamp(a < 0.0 ? -cosine : cosine, -1.0, 1.0);
}

// A unit vector at the angle with this haversine (sin^2 of half of it, which small angles keep their digits in) to `axis`, turned
// about it by `turn` (0..1 of a turn). The frame about the axis: Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
vec3 direction_about(vec3 axis, float haversine, float turn) {
  float side = axis.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (side + axis.z);
  float b = axis.x * axis.y * a;
  vec3 first = vec3(1.0 + side * axis.x * axis.x * a, side * b, -side * axis.x);
  vec3 second = vec3(b, side + axis.y * axis.y * a, -axis.y);
  float sine = 2.0 * sqrt(max(0.0, haversine * (1.0 - haversine)));
  float angle = 2.0 * pi * turn;
  return normalize((sine * cos(angle)) * first + (sine * sin(angle)) * second + (1.0 - 2.0 * haversine) * axis);
}

// Even over a cap of the sphere about `axis` whose edge has this chord to the axis.
vec3 sample_cap(vec3 axis, float squared_chord, float u, float turn) {
  return direction_about(axis, 0.25 * squared_chord * u, turn);
}

// In proportion to the cosine to the normal.
vec3 sample_cosine(vec3 normal, float u, float turn) {
  float cosine = sqrt(u);
  return direction_about(normal, 0.5 * (1.0 - cosine), turn);
}
#endif
