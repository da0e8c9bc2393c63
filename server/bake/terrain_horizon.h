// How high the land stands towards an azimuth from each point of a terrain: what the shadows of one sun are looked up
// in.
#pragma once
#include <glm/vec2.hpp>
#include <stop_token>
#include <vector>

namespace cloudscape::bake {

struct HorizonProblem {
  const std::vector<float>& heights_m;  // side^2 lattice points, south row first, above any base
  int side = 0;                         // a power of two
  double spacing_m = 1;
  bool tiling = true;
  double water_m = -1e9;     // above the same base: what is seen lies on it where the land is lower
  glm::dvec2 towards{1, 0};  // unit vector, east and north
};

// Tangent of the height at which the land stands, at least a lattice spacing away, of each point; -0.2 where there is
// none. Lines of lattice points towards the azimuth each keep the upper convex hull of what lies ahead (de Floriani and
// Magillo 2003, "Algorithms for visibility computation on terrains": horizons); a point takes the mean of the two lines
// it lies between. Empty: stopped.
std::vector<float> horizon_tangents(const HorizonProblem& problem, std::stop_token stop = {});

}  // namespace cloudscape::bake
