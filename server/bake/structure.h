// The preprocessed structure: a low-resolution volume that encloses the clouds (Olajos 2.4.2), so that a march can go
// through the air outside in large steps.
#pragma once
#include <array>

#include "bake/baked_cloudscape.h"
#include "gpu/pass.h"

namespace cloudscape::bake {

class StructureBuilder {
 public:
  explicit StructureBuilder(gpu::ShaderLibrary& shaders);
  // RG32F, `baked.structure_size()` cells. Red: the greatest shape noise that the march can find in the cell and in the
  // cells `structure_padding` around it (wrapping east and north), where it mixes the finer channels in with `weights`.
  // It is above the threshold wherever cloud can be within the padding, whatever the threshold. Green: the same with a
  // layer of padding less. Built on the device when first asked for, and kept with the baked cloudscape for the last
  // few weights.
  const gpu::Texture& of(const BakedCloudscape& baked, const std::array<double, 3>& weights) const;

 private:
  gpu::Texture build(const BakedCloudscape& baked, const std::array<double, 3>& weights) const;
  gpu::VolumePass enclose_, pad_;
};

}  // namespace cloudscape::bake
