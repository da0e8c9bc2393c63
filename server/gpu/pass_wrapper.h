// The GLSL around a pass file that makes it a compute or a fragment shader.
#pragma once
#include <string>
#include <vector>

#include "gpu/context.h"
#include "gpu/texture.h"

namespace cloudscape::gpu {

inline constexpr int pass_block_binding = 7;  // the wrappers' own uniform block, above those that passes use
inline constexpr int tile_marks_unit = 17;    // of textures, above those that passes use

struct Wrapper {
  std::string prologue, epilogue;
};
Wrapper screen_wrapper(PassExecution execution, const std::vector<Format>& targets);
Wrapper volume_wrapper();
// Of fragment passes: one triangle over the viewport, or two for each tile that is marked.
std::string triangle_shader();
std::string tiles_shader();

}  // namespace cloudscape::gpu
