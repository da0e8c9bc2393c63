// A whole planet in the sun that absorbs nothing: white ground, air without aerosol and ozone, and perhaps cloud all
// round. The light that it takes from the beam is the light that it sends out, in all directions together.
#pragma once
#include <array>

#include "air_cases.h"

namespace cloudscape::render {

constexpr double planet_m = 6360e3, air_top_m = 6460e3, cloud_top_m = 6400e3;

// `cloud_depth`: optical depth of the cloud, from the ground to 40 km.
inline Cloudscape white_planet(double sun_deg, double cloud_depth) {
  Cloudscape sky = clear_world(sun_deg, 1);
  sky.sky.haze = 0, sky.sky.ozone = 0, sky.sky.stars = 0;
  sky.moon.brightness = 0;  // it would stand behind the planet, and be seen
  sky.volume.origin_m = glm::dvec3(0, 0, -planet_m) - cloud_top_m;
  sky.volume.size_m = glm::dvec3(2 * cloud_top_m);
  sky.medium.extinction_per_m = cloud_depth / (cloud_top_m - planet_m);
  sky.medium.phase = {PhaseKind::henyey_greenstein, 0.5};
  return sky;
}

// Rayleigh's scattering at sea level, 1/m (shaders/lib/atmosphere.glsl).
constexpr std::array rayleigh_of{7.18e-6, 13.73e-6, 32.22e-6};

// Optical depth of the chord that passes the planet's middle at `b`.
inline double limb_depth(double b, std::size_t colour, double cloud_per_m) {
  const double half = std::sqrt(air_top_m * air_top_m - b * b);
  constexpr int steps = 400;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double at = half * (i + 0.5) / steps, radius = std::hypot(b, at);
    sum += rayleigh_of[colour] * std::exp((planet_m - radius) / 8000) + (radius < cloud_top_m ? cloud_per_m : 0);
  }
  return 2 * sum * half / steps;
}

// Area that the planet takes from the beam, m2.
inline double taken_m2(std::size_t colour, double cloud_depth) {
  constexpr int rings = 400;
  double area = std::numbers::pi * planet_m * planet_m;
  for (int i = 0; i < rings; ++i) {
    const double width = (air_top_m - planet_m) / rings, b = planet_m + (i + 0.5) * width;
    area += (1 - std::exp(-limb_depth(b, colour, cloud_depth / (cloud_top_m - planet_m)))) * 2 * std::numbers::pi * b *
            width;
  }
  return area;
}

// Nodes and weights of Gauss and Legendre on -1..1, sixteen of them by symmetry.
constexpr std::array<std::array<double, 2>, 8> gauss{{{0.0950125098376374, 0.1894506104550685},
                                                      {0.2816035507792589, 0.1826034150449236},
                                                      {0.4580167776572274, 0.1691565193950025},
                                                      {0.6178762444026438, 0.1495959888165767},
                                                      {0.7554044083550030, 0.1246289712555339},
                                                      {0.8656312023878318, 0.0951585116824928},
                                                      {0.9445750230732326, 0.0622535239386479},
                                                      {0.9894009349916499, 0.0271524594117541}}};

// The share of that light that comes out again: the sun goes round a camera that sees the planet whole, and what it
// sees is summed over the angles between the two.
inline Colours sent_out(double cloud_depth, int side, int samples) {
  constexpr double width_m = 2 * air_top_m;
  Colours sum;
  std::uint32_t seed = 0;
  for (const auto& [node, weight] : gauss)
    for (const double cosine : {node, -node}) {
      const Cloudscape sky = white_planet(degrees(std::asin(cosine)), cloud_depth);
      FrameRequest request = through_air(traced_beam(sky, {{0, 0, 2e5}, 0, -90, 0}, side, samples, width_m));
      request.tracing.seed = ++seed;  // or the errors of all pictures would be one
      const Colours one = colours_of(TraceTest::traced(request));
      const double scale = 2 * std::numbers::pi * weight * width_m * width_m;
      sum.mean += scale * one.mean;
      sum.error += scale * scale * one.error * one.error;
    }
  for (std::size_t i = 0; i < 3; ++i) {
    const double taken = taken_m2(i, cloud_depth);
    sum.mean[static_cast<int>(i)] /= taken;
    sum.error[static_cast<int>(i)] = std::sqrt(sum.error[static_cast<int>(i)]) / taken;
  }
  return sum;
}

}  // namespace cloudscape::render
