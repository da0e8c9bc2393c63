// shaders/lib/display.glsl as C++.
#pragma once
#include <glm/vec3.hpp>

namespace cloudscape::bench {

// Display values of 0..1; curve as core's ToneCurve.
glm::vec3 shown_radiance(const glm::vec3& radiance, float exposure, int curve);

}  // namespace cloudscape::bench
