// Writes the wrappers' GLSL.
#include "gpu/pass_wrapper.h"

#include "gpu/tile_marks.h"

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

// Most passes write each pixel that they shade.
constexpr const char* leaving =
    "#ifdef PASS_LEAVES\n"
    "#define PASS_LEAVES_PIXEL leaves(pixel)\n"
    "#else\n"
    "#define PASS_LEAVES_PIXEL false\n"
    "#endif\n";

Wrapper compute_wrapper(const std::vector<Format>& targets) {
  Wrapper wrapper;
  wrapper.prologue = "layout(local_size_x = 8, local_size_y = 8) in;\n";
  for (std::size_t i = 0; i < targets.size(); ++i)
    wrapper.prologue += "layout(binding = " + std::to_string(i) + ", " + name_of(targets[i]) +
                        ") writeonly uniform image2D pass_target_" + std::to_string(i) + ";\n";
  wrapper.prologue += "layout(std140, binding = " + std::to_string(pass_block_binding) +
                      ") uniform ScreenPassBlock { ivec4 rect; } screen_pass;\n" + output_struct(targets.size());
  wrapper.epilogue = std::string(leaving) +
                     "void main() {\n"
                     "  if (any(greaterThanEqual(ivec2(gl_GlobalInvocationID.xy), screen_pass.rect.zw))) return;\n"
                     "  ivec2 pixel = screen_pass.rect.xy + ivec2(gl_GlobalInvocationID.xy);\n"
                     "  if (PASS_LEAVES_PIXEL) return;\n"
                     "  PassOutput result = shade(pixel);\n" +
                     for_each_target(targets.size(), "  imageStore(pass_target_$, pixel, result.target_$);") + "}\n";
  return wrapper;
}

Wrapper fragment_wrapper(std::size_t count) {
  return {for_each_target(count, "layout(location = $) out vec4 pass_target_$;") + output_struct(count),
          std::string(leaving) +
              "void main() {\n"
              "  ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
              "  if (PASS_LEAVES_PIXEL) discard;\n"
              "  PassOutput result = shade(pixel);\n" +
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

// The corners come from the vertex number alone.
std::string triangle_shader() {
  return "#version 450 core\n"
         "void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }\n";
}

// The two triangles of a tile are in the order that llvmpipe sees a rectangle in.
std::string tiles_shader() {
  return "#version 450 core\n"
         "layout(std140, binding = " +
         std::to_string(pass_block_binding) +
         ") uniform TilePassBlock { ivec4 rect; ivec4 tiles; } tile_pass;\n"
         "layout(binding = " +
         std::to_string(tile_marks_unit) +
         ") uniform sampler2D tile_marks;\n"
         "void main() {\n"
         "  int columns = tile_pass.tiles.x;\n"
         "  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);\n"
         "  if (columns == 0) return;\n"
         "  int tile = gl_VertexID / 6, corner = gl_VertexID - 6 * tile;\n"
         "  ivec2 at = ivec2(tile - tile / columns * columns, tile / columns);\n"
         "  ivec2 way = ivec2(corner == 1 || corner == 2 || corner == 4, corner >= 2 && corner != 3);\n"
         "  vec2 px = vec2((at + way) * " +
         std::to_string(TileMarks::tile_px) +
         ");\n"
         "  bool marked = texelFetch(tile_marks, at, 0).x > 0.0;\n"
         "  gl_Position = vec4(marked ? 2.0 * px / vec2(tile_pass.tiles.yz) - 1.0 : vec2(-1.0), 0.0, 1.0);\n"
         "}\n";
}

}  // namespace cloudscape::gpu
