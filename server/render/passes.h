// The screen passes of a frame, in their order: scene, march, smooth (moving pictures), composite, tone map.
#pragma once
#include "bake/baked_cloudscape.h"
#include "gpu/pass.h"
#include "render/sky_tables.h"
#include "render/targets.h"

namespace cloudscape::render {

class Passes {
 public:
  Passes(const gpu::Context& context, gpu::ShaderLibrary& shaders);
  // Rows of the march target: the scene behind them, then the clouds. `land`: textures of the scene's terrain. The
  // blocks must be bound.
  void march(const Targets& targets, const SkyTables::Set& sky, const bake::BakedCloudscape& baked,
             std::span<const gpu::Binding> land, int row_begin, int row_end) const;
  // The whole picture into targets.scratch, averaged with `previous`.
  void composite(const Targets& targets, const Accumulation& previous) const;
  void tone_map(const Targets& targets, const Accumulation& accumulation) const;
  void reload(gpu::ShaderLibrary& shaders);

 private:
  struct Precision {  // HDR targets of 16 or 32 bits
    gpu::ScreenPass scene, march;
  };
  Precision half_, full_;
  gpu::ScreenPass smooth_, composite_, tone_map_;
};

}  // namespace cloudscape::render
