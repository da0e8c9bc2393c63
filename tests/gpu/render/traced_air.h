// A Monte Carlo tracer of the clear atmosphere, in double precision and independent of the shaders: what the sky tables
// are held against. Free flights by delta tracking, the sun by next-event estimation, any number of orders, one
// wavelength at a time.
#pragma once
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace cloudscape::render {

struct TracedAir {
  glm::dvec3 sun;     // unit, towards it
  double albedo = 0;  // of the ground
  double haze = 1;
  int most_orders = 1000;  // 1: single scattering
};

// Radiance by irradiance (1/sr) of the sky in `direction` from `altitude_m`, red, green and blue, and its standard
// error.
struct TracedRadiance {
  glm::dvec3 mean, error;
};
// To the ground where the ray meets it, which shines as well; or no farther than `distance_m`, to something black.
TracedRadiance traced_sky(const TracedAir& air, double altitude_m, const glm::dvec3& direction, int paths,
                          double distance_m = 1e9);

}  // namespace cloudscape::render
