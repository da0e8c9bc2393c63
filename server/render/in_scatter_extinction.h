// The extinction of a cloudscape's clouds at the points of its in-scatter volume.
#pragma once
#include "bake/in_scatter.h"
#include "core/beside_frames.h"
#include "gpu/pass.h"
#include "render/blocks.h"
#include "render/in_scatter_plan.h"

namespace cloudscape::render {

// The grids of a plan, one for each of its thresholds, as if that were the same everywhere; computed in slices.
struct InScatterGrids {
  std::vector<bake::InScatterGrid> done;
  gpu::Texture extinction = {};  // of the next one
  int next_layer = 0;
};

class InScatterExtinction {
 public:
  explicit InScatterExtinction(gpu::ShaderLibrary& shaders);
  // Computes the next slice, shorter where frames do not wait for it; true when all are done. `marched`: as
  // `as_marched` makes it. Binds blocks of its own.
  bool advance(const std::shared_ptr<const Cloudscape>& marched, const bake::BakedCloudscape& baked,
               const InScatterPlan& plan, InScatterGrids& grids, Beside beside) const;

 private:
  gpu::VolumePass pass_;
  mutable gpu::UniformBlock<CloudBlock> cloud_;
  mutable gpu::UniformBlock<InScatterBlock> block_;
};

}  // namespace cloudscape::render
