// The uniform blocks of the baking shaders as C++ structs.
#pragma once
#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <utility>
#include <vector>

namespace cloudscape::bake {
using glm::ivec4, glm::uvec4, glm::vec4;
#include "shared/bake_block.glsl"
#include "shared/distance_block.glsl"
#include "shared/structure_block.glsl"
#include "shared/terrain_bake_block.glsl"
}  // namespace cloudscape::bake
