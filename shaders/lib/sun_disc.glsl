// How bright the sun's disc is from its middle to its limb.
#ifndef LIB_SUN_DISC
#define LIB_SUN_DISC

// Radiance over the disc's mean at `radius` (0 in the middle, 1 at the limb): mu^a, a = 0.292 / wavelength (um) - 0.023 (Hestroffer and
// Magnan 1998, "Wavelength dependency of the Solar limb darkening", A&A 333, 338), at 680, 550 and 440 nm. The mean of mu^a over a
// disc is 2 / (a + 2).
vec3 limb_darkening(float radius) {
  float mu = sqrt(max(1.0 - radius * radius, 1.0e-6));
  vec3 a = vec3(0.406, 0.508, 0.641);
  return pow(vec3(mu), a) * (0.5 * a + 1.0);
}
#endif
