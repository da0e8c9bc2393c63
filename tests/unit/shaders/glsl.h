// shaders/lib as C++, in a namespace of each file's own. Such a file is compiled with -fsingle-precision-constant, so
// that 0.1 is a float as in GLSL; a constant that must be a double here has the suffix L.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "bake/permutation.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
namespace {
namespace glsl {
using namespace glm;

// What lib/perlin.glsl asks of its includer.
inline std::array<std::uint8_t, 256> current_permutation = cloudscape::bake::permutation_table(0);
int permutation(int index) { return current_permutation.at(static_cast<std::size_t>(index)); }

#include "lib/atmosphere.glsl"
#include "lib/bloom.glsl"
#include "lib/constants.glsl"
#include "lib/display.glsl"
#include "lib/ground.glsl"
#include "lib/hash.glsl"
#include "lib/intersect.glsl"
#include "lib/lens.glsl"
#include "lib/perlin.glsl"
#include "lib/phase.glsl"
#include "lib/relief.glsl"
#include "lib/reprojection.glsl"
#include "lib/sampling.glsl"
#include "lib/shape.glsl"
#include "lib/sky_mapping.glsl"
#include "lib/stars.glsl"
#include "lib/sun_disc.glsl"
#include "lib/transport.glsl"
#include "lib/water.glsl"
#include "lib/worley.glsl"

}  // namespace glsl
}  // namespace
#pragma GCC diagnostic pop
