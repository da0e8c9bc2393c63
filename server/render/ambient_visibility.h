// What of the light of the sky above, of the horizon beside and of the ground below comes to points of the clouds' tile
// through the cloud between: a volume for the light models that do not solve for it. Independent of the sun.
#pragma once
#include "render/light_volumes.h"

namespace cloudscape::render {

// Whether the march looks it up.
bool has_ambient_visibility(const Cloudscape& sky);

class AmbientVisibilities {
 public:
  AmbientVisibilities(gpu::ShaderLibrary& shaders, CloudDensities& densities);
  // As LightVolumes has it; also true where the light model needs none.
  bool prepare(const CloudDensities::Wanted& wanted, std::shared_ptr<const gpu::Texture>& visibility);
  void reload(gpu::ShaderLibrary& shaders) { volumes_.reload(shaders); }
  int slices() const { return volumes_.slices(); }

  static constexpr int across = 48, layers = 16;  // tuned: twice as many across show in no picture, and take four times
  static constexpr int layers_per_slice = 1;      // tuned: about 10 ms, since a point looks along 20 ways

 private:
  LightVolumes volumes_;
};

}  // namespace cloudscape::render
