// The directions of the discrete ordinates.
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <vector>

namespace cloudscape::bake {

struct Ordinate {
  glm::vec3 direction;  // where the light comes from
  float weight;         // all add up to 1
};

// Level-symmetric quadrature S6 of 48 directions (Lewis and Miller 1984, "Computational Methods of Neutron Transport",
// table 4-1).
std::vector<Ordinate> ordinates();

// The four points of a grid that a ray comes by one step from a point: the first plane that it meets, and the weights
// of that plane's points about it.
struct Stencil {
  int axis = 0;                     // the plane's: 0 east, 1 north, 2 up
  glm::ivec3 towards{1};            // sign of the direction by axis
  std::array<int, 2> others{1, 2};  // the other axes, ascending
  std::array<float, 2> shares{};    // how far between the points along them, 0..1
  float length_m = 1;
};
Stencil stencil_of(const glm::vec3& direction, const glm::dvec3& spacing_m);

}  // namespace cloudscape::bake
