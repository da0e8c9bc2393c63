// The uniform blocks of the rendering shaders as C++ structs.
#pragma once
#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <utility>
#include <vector>

namespace cloudscape::render {
using glm::ivec4, glm::mat4, glm::uvec4, glm::vec4;
#include "shared/bloom_block.glsl"
#include "shared/cloud_block.glsl"
#include "shared/density_block.glsl"
#include "shared/frame_block.glsl"
#include "shared/in_scatter_block.glsl"
#include "shared/resolve_block.glsl"
#include "shared/sky_block.glsl"
#include "shared/sun_block.glsl"
#include "shared/terrain_block.glsl"
#include "shared/trace_block.glsl"
#include "shared/water_block.glsl"
}  // namespace cloudscape::render
