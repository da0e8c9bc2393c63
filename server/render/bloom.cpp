#include "render/bloom.h"

#include <initializer_list>

namespace cloudscape::render {
namespace {

using gpu::Binding, gpu::Format, gpu::ScreenPass, gpu::Texture;

void run_whole(const ScreenPass& pass, const Texture& target, std::initializer_list<Binding> textures) {
  const Texture* targets[] = {&target};
  pass.run({0, 0, target.width(), target.height()}, targets, textures);
}

}  // namespace

Bloom::Bloom(const gpu::Context& context, gpu::ShaderLibrary& shaders)
    : bright_(context, shaders, "render/bloom_bright.glsl", {Format::rgba32f}),
      halve_(context, shaders, "render/bloom_halve.glsl", {Format::rgba32f}),
      total_(context, shaders, "render/bloom_total.glsl", {Format::r32f}),
      horizontal_(context, shaders, "render/bloom_horizontal.glsl", {Format::rgba32f}),
      vertical_(context, shaders, "render/bloom_vertical.glsl", {Format::rgba32f}),
      widen_(context, shaders, "render/bloom_widen.glsl", {Format::rgba32f}) {}

void Bloom::shrink(const BloomChain& chain, const Texture& radiance) const {
  const Texture* finer = &radiance;
  for (const BloomLevel& level : chain.levels) {
    level.block.bind();
    run_whole(finer == &radiance ? bright_ : halve_, level.bright, {{0, finer}});
    finer = &level.bright;
  }
  run_whole(total_, chain.scale, {{0, finer}});
}

// The level's glow: its own Gaussian and what the coarser levels have. `coarser` is nullptr where there are none.
void Bloom::widen(const BloomChain& chain, std::size_t index, const Texture* coarser) const {
  const BloomLevel& level = chain.levels[index];
  level.block.bind();
  if (!level.rows) return run_whole(widen_, level.glow, {{0, coarser}});
  run_whole(horizontal_, *level.rows, {{0, &level.bright}});
  run_whole(vertical_, level.glow, {{0, &*level.rows}, {1, &chain.scale}, {2, coarser ? coarser : &chain.black}});
}

const Texture& Bloom::glow(const BloomChain& chain, const Texture& radiance) const {
  shrink(chain, radiance);
  const Texture* coarser = nullptr;
  for (std::size_t index = chain.levels.size(); index-- > 0;) {
    if (!coarser && !chain.levels[index].rows) continue;  // coarser than any Gaussian: only for the total
    widen(chain, index, coarser);
    coarser = &chain.levels[index].glow;
  }
  return *coarser;
}

void Bloom::reload(gpu::ShaderLibrary& shaders) {
  for (ScreenPass* pass : {&bright_, &halve_, &total_, &horizontal_, &vertical_, &widen_}) pass->reload(shaders);
}

}  // namespace cloudscape::render
