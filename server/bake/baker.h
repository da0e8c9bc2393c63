// Bakes noise into textures on the device, slab by slab, so that frames can be rendered in between.
#pragma once
#include <optional>

#include "bake/baked_cloudscape.h"
#include "bake/layer_job.h"
#include "bake/noise_inputs.h"
#include "gpu/pass.h"

namespace cloudscape::bake {

class Baker {
 public:
  explicit Baker(gpu::ShaderLibrary& shaders);

 private:
  friend class BakeJob;
  gpu::VolumePass shape_, mixed_, detail_, variation_;
  LayerPasses layers_;
};

class BakeJob {
 public:
  BakeJob(const Baker& baker, BakeRecipe recipe);
  bool advance();              // bakes the next slab; true when all is done
  double progress() const;     // 0..1
  BakedTexels texels() const;  // once advance() said true; waits for the device

 private:
  const Baker& baker_;
  BakeRecipe recipe_;
  gpu::Texture shape_, detail_, variation_;
  NoiseInputs inputs_;
  gpu::UniformBlock<BakeBlock> block_;
  std::optional<LayerJob> layers_;  // which bakes the shape where there are several
  bool begun_ = false;
  int next_z_ = 0;
};

}  // namespace cloudscape::bake
