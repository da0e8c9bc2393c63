// Programs and how they run: compute passes over a volume, and screen passes that are written once and run either way.
#pragma once
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gpu/context.h"
#include "gpu/shader_source.h"
#include "gpu/texture.h"
#include "gpu/tile_marks.h"

namespace cloudscape::gpu {

class Program {
 public:
  Program() = default;
  static Program compute(const ShaderSource& source, const std::string& label);
  // With a built-in vertex shader: a full-screen triangle, or marked tiles where the pass block says so.
  static Program fragment(const ShaderSource& source, const std::string& label, bool tiles = false);
  ~Program();
  Program(Program&& other) noexcept;
  Program& operator=(Program&& other) noexcept;
  unsigned id() const { return id_; }

  // (name, byte offset) of each member of a uniform block, as the driver laid it out; for the test of shaders/shared.
  std::vector<std::pair<std::string, int>> block_offsets(const std::string& block) const;

 private:
  unsigned id_ = 0;
};

struct Rect {
  int x = 0, y = 0, width = 0, height = 0;
};
struct Binding {  // a texture at a sampler's `layout(binding = unit)`
  int unit;
  const Texture* texture;
};

// Whether a pass can also shade marked tiles alone.
enum class Shades { rects, rects_and_tiles };

// A shader file that defines `PassOutput shade(ivec2 pixel)`; the wrapper declares `struct PassOutput { vec4 target_0;
// ... }` with as many members as there are target formats, includes the file, and writes what it returns, as a compute
// dispatch (8x8 groups) or as a full-screen triangle. Pixel (0, 0) is the top left one, which is also the first in
// memory. A shader that defines PASS_LEAVES and `bool leaves(ivec2 pixel)` leaves some pixels as they are.
class ScreenPass {
 public:
  // `defines`: lines before the shader's, for one of its variants.
  ScreenPass(const Context& context, ShaderLibrary& shaders, const std::string& path, std::vector<Format> targets,
             const std::string& defines = {}, Shades shades = Shades::rects);
  // With one execution, whatever the context prefers, to compare them.
  ScreenPass(PassExecution execution, ShaderLibrary& shaders, const std::string& path, std::vector<Format> targets,
             std::string defines = {}, Shades shades = Shades::rects);
  // Shades the pixels of `rect` (clipped to the targets, which all have one size, and none of which is read). Uniform
  // blocks are bound by the caller (UniformBlock::bind). Makes what it wrote visible to later passes.
  void run(Rect rect, std::span<const Texture* const> targets, std::span<const Binding> textures) const;
  // Shades the marked tiles. A compute pass shades all: there, pixels that nobody asks for cost next to nothing.
  void run_tiles(const TileMarks& marks, std::span<const Texture* const> targets,
                 std::span<const Binding> textures) const;
  // Compiles the shader anew; if that fails the old program stays and the error is logged.
  void reload(ShaderLibrary& shaders);
  const Program& program() const { return program_; }

 private:
  Program build(ShaderLibrary& shaders) const;
  void check(std::span<const Texture* const> targets, std::span<const Binding> textures) const;
  void use(std::span<const Binding> textures) const;
  std::string path_, defines_;
  std::vector<Format> formats_;
  PassExecution execution_;
  Shades shades_;
  Program program_;
  mutable UniformBuffer block_;  // written by each run
};

// A compute shader `layout(local_size_x = 4, local_size_y = 4, local_size_z = 4)` that writes one 3D image at binding
// 0, whose own texel it may read before.
class VolumePass {
 public:
  VolumePass(ShaderLibrary& shaders, const std::string& path);
  // Runs texels z_begin <= z < z_end of `target`; the shader adds `volume_pass.z_begin` (block at binding 7) to its z,
  // and leaves out z >= `volume_pass.z_end` where the range is no multiple of 4.
  void run(const Texture& target, int z_begin, int z_end, std::span<const Binding> textures) const;
  const Program& program() const { return program_; }

 private:
  Program program_;
  mutable UniformBuffer range_;  // written by each run
};

}  // namespace cloudscape::gpu
