// Writes the wrappers' GLSL.
#include "gpu/pass_wrapper.h"

namespace cloudscape::gpu {
namespace {

// One line for each target, with every `$` as its number.
std::string for_each_target(std::size_t count, const std::string& line) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
    for (const char c : line + "\n") text += c == '$' ? std::to_string(i) : std::string(1, c);
  return text;
}

std::string output_struct(std::size_t count) {
  return "struct PassOutput {\n" + for_each_target(count, "  vec4 target_$;") + "};\n";
}

Wrapper compute_wrapper(const std::vector<Format>& targets) {
  Wrapper wrapper;
  wrapper.prologue = "layout(local_size_x = 8, local_size_y = 8) in;\n";
  for (std::size_t i = 0; i < targets.size(); ++i)
    wrapper.prologue += "layout(binding = " + std::to_string(i) + ", " + name_of(targets[i]) +
                        ") writeonly uniform image2D pass_target_" + std::to_string(i) + ";\n";
  wrapper.prologue += "layout(std140, binding = " + std::to_string(pass_block_binding) +
                      ") uniform ScreenPassBlock { ivec4 rect; } screen_pass;\n" + output_struct(targets.size());
  wrapper.epilogue =
      "void main() {\n"
      "  if (any(greaterThanEqual(ivec2(gl_GlobalInvocationID.xy), screen_pass.rect.zw))) return;\n"
      "  ivec2 pixel = screen_pass.rect.xy + ivec2(gl_GlobalInvocationID.xy);\n"
      "  PassOutput result = shade(pixel);\n" +
      for_each_target(targets.size(), "  imageStore(pass_target_$, pixel, result.target_$);") + "}\n";
  return wrapper;
}

Wrapper fragment_wrapper(std::size_t count) {
  return {for_each_target(count, "layout(location = $) out vec4 pass_target_$;") + output_struct(count),
          "void main() {\n  PassOutput result = shade(ivec2(gl_FragCoord.xy));\n" +
              for_each_target(count, "  pass_target_$ = result.target_$;") + "}\n"};
}

}  // namespace

Wrapper screen_wrapper(PassExecution execution, const std::vector<Format>& targets) {
  return execution == PassExecution::compute ? compute_wrapper(targets) : fragment_wrapper(targets.size());
}

Wrapper volume_wrapper() {
  return {"layout(std140, binding = " + std::to_string(pass_block_binding) +
              ") uniform VolumePassBlock { int z_begin; int z_end; } volume_pass;\n",
          ""};
}

}  // namespace cloudscape::gpu
