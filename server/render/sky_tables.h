// Tables of the clear sky, kept for the few skies that are being looked at.
#pragma once
#include <list>
#include <string>

#include "gpu/pass.h"
#include "render/blocks.h"

namespace cloudscape::render {

class SkyTables {
 public:
  struct Set {
    std::string key;
    gpu::Texture transmittance, view, light;
  };
  SkyTables(const gpu::Context& context, gpu::ShaderLibrary& shaders);
  // The tables for this frame; the frame and cloud blocks must be bound. Computed only if none of the last few fits.
  const Set& get(const FrameBlock& frame, const CloudBlock& cloud);
  void reload(gpu::ShaderLibrary& shaders);

 private:
  void compute(Set& set) const;
  gpu::ScreenPass transmittance_, view_, light_;
  std::list<Set> sets_;  // most recently used first
};

}  // namespace cloudscape::render
