// The passes of the bloom (Olajos 2.7): what is brighter than the threshold, shrunk level by level, blurred, and
// summed.
#pragma once
#include "gpu/pass.h"
#include "render/bloom_chain.h"

namespace cloudscape::render {

class Bloom {
 public:
  Bloom(const gpu::Context& context, gpu::ShaderLibrary& shaders);
  // The radiance that the glow adds to a picture (`radiance`, rgba32f): a texture of the chain, to be interpolated. The
  // frame block must be bound.
  const gpu::Texture& glow(const BloomChain& chain, const gpu::Texture& radiance) const;
  void reload(gpu::ShaderLibrary& shaders);

 private:
  void shrink(const BloomChain& chain, const gpu::Texture& radiance) const;
  void widen(const BloomChain& chain, std::size_t level, const gpu::Texture* coarser) const;
  gpu::ScreenPass bright_, halve_, total_, horizontal_, vertical_, widen_;
};

}  // namespace cloudscape::render
