// Checks shaders without a device: their whole text, as the passes would compile it, by glslangValidator.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "gpu/shader_source.h"

namespace cloudscape::gpu {

struct ShaderUnit {
  std::string name, stage;  // "render/march.glsl", "comp"
  ShaderSource source;
};

// Each program of the library: `.comp` files as volume passes, files that define `PassOutput shade(` as screen passes
// in both executions, with the targets that their first line announces ("// targets: rgba16f r32f"). All other files
// are only included. Throws Error for a screen pass that announces none.
std::vector<ShaderUnit> shader_units(const ShaderLibrary& shaders);

// What `validator` (the path of glslangValidator) finds wrong, as file:line: message; "" if all is well. The whole
// texts are left in `folder`.
std::string check_shaders(const ShaderLibrary& shaders, const std::string& validator,
                          const std::filesystem::path& folder);

}  // namespace cloudscape::gpu
