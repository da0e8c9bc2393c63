// Light transport along a ray.
#ifndef LIB_TRANSPORT
#define LIB_TRANSPORT

// What a segment of constant extinction adds to the radiance per unit of source (scattered radiance per metre), and its
// transmittance: the energy-conserving step (Hillaire 2016, "Physically Based Sky, Atmosphere and Cloud Rendering in Frostbite").
// x: (1 - exp(-extinction d)) / extinction, m; y: exp(-extinction d).
vec2 integrate_segment(float extinction_per_m, float length_m) {
  float optical_depth = extinction_per_m * length_m;
  float transmittance = exp(-optical_depth);
  float path_m = optical_depth < 1.0e-3 ? length_m * (1.0 - 0.5 * optical_depth) : (1.0 - transmittance) / extinction_per_m;
  return vec2(path_m, transmittance);
}

// In-scattered light of the thesis: exp(-m d) (1 - exp(-c d)) for optical depth d towards the sun (Olajos 2.5, figure 2.12).
float olajos_light(float optical_depth, float attenuation, float in_scatter) {
  return exp(-attenuation * optical_depth) * (1.0 - exp(-in_scatter * optical_depth));
}

// 2 exp(-d) (1 - exp(-2 d)): darker where light has met little cloud that could scatter it (Schneider and Vos 2015, "The
// Real-time Volumetric Cloudscapes of Horizon Zero Dawn").
float beer_powder(float optical_depth) { return 2.0 * exp(-optical_depth) * (1.0 - exp(-2.0 * optical_depth)); }
#endif
