// How much cloud stands between points of the clouds' tile and the light: a volume for shadows on the ground and in the
// air, and for light from farther than the march looks.
#pragma once
#include "render/light_volumes.h"

namespace cloudscape::render {

class SunDepths {
 public:
  SunDepths(gpu::ShaderLibrary& shaders, CloudDensities& densities);
  // As LightVolumes has it.
  bool prepare(const CloudDensities::Wanted& wanted, std::shared_ptr<const gpu::Texture>& depth);
  void reload(gpu::ShaderLibrary& shaders) { volumes_.reload(shaders); }
  int slices() const { return volumes_.slices(); }

 private:
  LightVolumes volumes_;
};

}  // namespace cloudscape::render
