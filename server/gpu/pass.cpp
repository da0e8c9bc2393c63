// Runs passes: what they bind, draw or dispatch, and the barrier after it.
#include "gpu/pass.h"

#include <algorithm>
#include <array>

#include "core/error.h"
#include "core/log.h"
#include "gpu/format.h"
#include "gpu/pass_wrapper.h"

namespace cloudscape::gpu {
namespace {

constexpr int screen_group = 8, volume_group = 4;  // the local sizes of the compute shaders
constexpr std::size_t most_targets = 8;            // what OpenGL 4.5 promises of draw buffers and of image units

GLuint groups(int texels, int group) { return static_cast<GLuint>((texels + group - 1) / group); }

void bind_textures(std::span<const Binding> textures) {
  for (const Binding& binding : textures) glBindTextureUnit(static_cast<GLuint>(binding.unit), binding.texture->id());
}

// Whatever a later pass does with what a compute pass wrote: sample, load, overwrite, read back, draw into.
void make_image_writes_visible() {
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                  GL_PIXEL_BUFFER_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

void bind_image(std::size_t unit, const Texture& target, GLenum access = GL_WRITE_ONLY) {
  glBindImageTexture(static_cast<GLuint>(unit), target.id(), 0, GL_TRUE, 0, access, row_of(target.format()).internal);
}

class Framebuffer {
 public:
  explicit Framebuffer(std::span<const Texture* const> targets) {
    glCreateFramebuffers(1, &id_);
    std::array<GLenum, most_targets> buffers{};
    for (std::size_t i = 0; i < targets.size(); ++i) {
      buffers[i] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
      glNamedFramebufferTexture(id_, buffers[i], targets[i]->id(), 0);
    }
    glNamedFramebufferDrawBuffers(id_, static_cast<GLsizei>(targets.size()), buffers.data());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, id_);
  }
  ~Framebuffer() { glDeleteFramebuffers(1, &id_); }
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

 private:
  GLuint id_ = 0;
};

// What the wrappers and the vertex shader of tiles know of a run.
struct PassBlock {
  Rect rect;
  int columns = 0, width = 0, height = 0, unused = 0;  // of tiles, where they are drawn; of the targets
};

void draw(Rect rect, std::span<const Texture* const> targets, int vertices = 3) {
  const Framebuffer framebuffer(targets);
  glViewport(0, 0, targets[0]->width(), targets[0]->height());
  glEnable(GL_SCISSOR_TEST);
  glScissor(rect.x, rect.y, rect.width, rect.height);
  glDrawArrays(GL_TRIANGLES, 0, vertices);
  glDisable(GL_SCISSOR_TEST);
}

void dispatch(Rect rect, std::span<const Texture* const> targets) {
  for (std::size_t i = 0; i < targets.size(); ++i) bind_image(i, *targets[i]);
  glDispatchCompute(groups(rect.width, screen_group), groups(rect.height, screen_group), 1);
  make_image_writes_visible();
}

Rect clipped(Rect rect, const Texture& target) {
  const int left = std::max(rect.x, 0), top = std::max(rect.y, 0);
  return {left, top, std::min(rect.x + rect.width, target.width()) - left,
          std::min(rect.y + rect.height, target.height()) - top};
}

template <class Numbers>
void upload(UniformBuffer& block, const Numbers& numbers) {
  block.upload(std::as_bytes(std::span(numbers)));
  block.bind(pass_block_binding);
}

}  // namespace

ScreenPass::ScreenPass(const Context& context, ShaderLibrary& shaders, const std::string& path,
                       std::vector<Format> targets, const std::string& defines, Shades shades)
    : ScreenPass(context.execution(), shaders, path, std::move(targets), defines, shades) {}

ScreenPass::ScreenPass(PassExecution execution, ShaderLibrary& shaders, const std::string& path,
                       std::vector<Format> targets, std::string defines, Shades shades)
    : path_(path),
      defines_(std::move(defines)),
      formats_(std::move(targets)),
      execution_(execution),
      shades_(shades),
      block_(sizeof(PassBlock), path + " pass") {
  if (formats_.empty() || formats_.size() > most_targets)
    throw Error("the screen pass '" + path + "' needs 1 to " + std::to_string(most_targets) + " targets");
  program_ = build(shaders);
}

Program ScreenPass::build(ShaderLibrary& shaders) const {
  const Wrapper wrapper = screen_wrapper(execution_, formats_);
  const ShaderSource source = shaders.load(path_, defines_ + wrapper.prologue, wrapper.epilogue);
  return execution_ == PassExecution::compute ? Program::compute(source, path_)
                                              : Program::fragment(source, path_, shades_ == Shades::rects_and_tiles);
}

void ScreenPass::reload(ShaderLibrary& shaders) {
  try {
    program_ = build(shaders);
    log::info("reloaded the shader {}", path_);
  } catch (const Error& error) {
    log::error("{} (the one before stays in use)", error.what());
  }
}

void ScreenPass::check(std::span<const Texture* const> targets, std::span<const Binding> textures) const {
  if (targets.size() != formats_.size())
    throw Error("the screen pass '" + path_ + "' writes " + std::to_string(formats_.size()) + " targets, not " +
                std::to_string(targets.size()));
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Texture& target = *targets[i];
    if (target.format() != formats_[i])
      throw Error("target " + std::to_string(i) + " of the screen pass '" + path_ + "' is " + name_of(target.format()) +
                  ": must be " + name_of(formats_[i]));
    if (target.width() != targets[0]->width() || target.height() != targets[0]->height())
      throw Error("the targets of the screen pass '" + path_ + "' differ in size");
    // Undefined in OpenGL, and it comes out differently in the two executions.
    if (std::ranges::any_of(textures, [&](const Binding& binding) { return binding.texture == &target; }))
      throw Error("the screen pass '" + path_ + "' reads target " + std::to_string(i) + ", which it writes");
  }
}

void ScreenPass::use(std::span<const Binding> textures) const {
  glUseProgram(program_.id());
  bind_textures(textures);
}

void ScreenPass::run(Rect rect, std::span<const Texture* const> targets, std::span<const Binding> textures) const {
  check(targets, textures);
  const Rect area = clipped(rect, *targets[0]);
  if (area.width <= 0 || area.height <= 0) return;
  use(textures);
  const bool draws = execution_ == PassExecution::fragment;
  if (!draws || shades_ == Shades::rects_and_tiles) upload(block_, std::array{PassBlock{area}});
  draws ? draw(area, targets) : dispatch(area, targets);
}

void ScreenPass::run_tiles(const TileMarks& marks, std::span<const Texture* const> targets,
                           std::span<const Binding> textures) const {
  const Rect all{0, 0, targets[0]->width(), targets[0]->height()};
  if (execution_ == PassExecution::compute) return run(all, targets, textures);
  if (shades_ == Shades::rects) throw Error("the screen pass '" + path_ + "' shades no tiles");
  check(targets, textures);
  use(textures);
  const Texture& tiles = marks.texture();
  glBindTextureUnit(tile_marks_unit, tiles.id());
  upload(block_, std::array{PassBlock{all, tiles.width(), all.width, all.height}});
  constexpr int vertices_per_tile = 6;
  draw(all, targets, vertices_per_tile * tiles.width() * tiles.height());
}

VolumePass::VolumePass(ShaderLibrary& shaders, const std::string& path)
    : program_(Program::compute(shaders.load(path, volume_wrapper().prologue), path)),
      range_(4 * sizeof(int), path + " range") {}

void VolumePass::run(const Texture& target, int z_begin, int z_end, std::span<const Binding> textures) const {
  if (z_begin < 0 || z_end > target.depth() || z_begin > z_end)
    throw Error("a volume of depth " + std::to_string(target.depth()) + " has no slices " + std::to_string(z_begin) +
                " to " + std::to_string(z_end));
  glUseProgram(program_.id());
  bind_textures(textures);
  upload(range_, std::array{z_begin, z_end, 0, 0});
  bind_image(0, target, GL_READ_WRITE);
  glDispatchCompute(groups(target.width(), volume_group), groups(target.height(), volume_group),
                    groups(z_end - z_begin, volume_group));
  make_image_writes_visible();
}

}  // namespace cloudscape::gpu
