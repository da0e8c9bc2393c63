// Density in voxels, as it comes from a file and goes into one.
#pragma once
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace cloudscape {

struct Voxels {
  glm::ivec3 size{0};            // east, north, up
  std::vector<float> densities;  // at the voxels' middles; east fastest, then north, then up
  glm::dvec3 low{0}, high{0};    // corners of the box of the voxels, in the file's units; 0 where the file has no place
};

inline std::size_t count_of(const glm::ivec3& size) {
  return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z);
}

}  // namespace cloudscape
