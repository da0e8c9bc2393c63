// The extinction of a cloudscape's clouds at the points of its in-scatter volume.
#pragma once
#include "bake/in_scatter.h"
#include "gpu/pass.h"
#include "render/blocks.h"
#include "render/in_scatter_plan.h"

namespace cloudscape::render {

class InScatterExtinction {
 public:
  explicit InScatterExtinction(gpu::ShaderLibrary& shaders);
  // As if the threshold were the same everywhere. `marched`: as `as_marched` makes it. Binds blocks of its own.
  bake::InScatterGrid grid_of(const std::shared_ptr<const Cloudscape>& marched, const bake::BakedCloudscape& baked,
                              const InScatterPlan& plan, double threshold) const;

 private:
  gpu::VolumePass pass_;
  mutable gpu::UniformBlock<CloudBlock> cloud_;
  mutable gpu::UniformBlock<InScatterBlock> block_;
};

}  // namespace cloudscape::render
