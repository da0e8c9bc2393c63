// Compiled with -fsingle-precision-constant, and therefore without headers that have constants of their own.
#include "bench/display_curve.h"

#include <glm/glm.hpp>

namespace cloudscape::bench {
namespace {
namespace glsl {
using namespace glm;
#include "lib/display.glsl"
}  // namespace glsl
}  // namespace

glm::vec3 shown_radiance(const glm::vec3& radiance, float exposure, int curve) {
  return glsl::display_from_radiance(radiance, exposure, curve);
}

}  // namespace cloudscape::bench
