// Phase functions, 1/sr; cos_theta = 1 is forward scattering and the integral over the sphere is 1.
#ifndef LIB_PHASE
#define LIB_PHASE
#include "lib/constants.glsl"

const float phase_isotropic = 0.07957747155;  // 1 / (4 pi)

// Henyey and Greenstein 1941; g is the mean cosine (Olajos 2.6).
float phase_henyey_greenstein(float cos_theta, float g) {
  float d = max(1.0 + g * g - 2.0 * g * cos_theta, 1.0e-6);
  return phase_isotropic * (1.0 - g * g) / (d * sqrt(d));
}

float phase_rayleigh(float cos_theta) { return phase_isotropic * 0.75 * (1.0 + cos_theta * cos_theta); }

// Cornette and Shanks 1992: Henyey-Greenstein with the backward rise of small aerosol.
float phase_cornette_shanks(float cos_theta, float g) {
  float d = max(1.0 + g * g - 2.0 * g * cos_theta, 1.0e-6);
  return phase_isotropic * 1.5 * (1.0 - g * g) / (2.0 + g * g) * (1.0 + cos_theta * cos_theta) / (d * sqrt(d));
}

// Where a scattering angle lies in a phase table, 0..1: sqrt(t) / (1 + sqrt(t)) with t = tan(angle / 2) = chord / far_chord.
// Between unit vectors: chord is from the direction of the ray to that of the sun, far_chord to the point opposite the sun. Both
// are exact near their zeros, where the cosine has no digits left.
float phase_table_coordinate(float chord, float far_chord) {
  float forward = sqrt(chord);
  return forward / (forward + sqrt(far_chord));
}

// The inverse: sin^2 of half the angle at a place in the table.
float phase_table_haversine(float coordinate) {
  float near = coordinate * coordinate;
  float far = (1.0 - coordinate) * (1.0 - coordinate);
  return near * near / (near * near + far * far);
}

// The document's phase function, or what broadened orders have in place of the table of mie (4); kind as core's PhaseKind. `broadening` scales both asymmetries (1: the function itself).
float phase_of_kind(int kind, float cos_theta, float g, float second_g, float second_weight, float broadening) {
  if (kind == 0 || kind == 4) return phase_henyey_greenstein(cos_theta, g * broadening);
  if (kind == 1) {
    return mix(phase_henyey_greenstein(cos_theta, g * broadening), phase_henyey_greenstein(cos_theta, second_g * broadening),
               second_weight);
  }
  if (kind == 2) return mix(phase_isotropic, phase_rayleigh(cos_theta), broadening);
  return phase_isotropic;
}
#endif
