// Bakes noise into textures, slab by slab, so that frames can be rendered in between.
#pragma once
#include <memory>
#include <optional>

#include "bake/baked_cloudscape.h"
#include "bake/layer_job.h"
#include "gpu/pass.h"

namespace cloudscape::bake {

// Where the texels are computed: the device's shaders, or the processor, where the device is nothing else.
enum class BakedBy { device, processor };

// A bake under way.
class BakeJob {
 public:
  virtual ~BakeJob() = default;
  virtual bool advance() = 0;              // bakes the next slab; true when all is done
  virtual double progress() const = 0;     // 0..1
  virtual BakedTexels texels() const = 0;  // once advance() said true; waits for the device
};

class Baker {
 public:
  Baker(const gpu::Context& context, gpu::ShaderLibrary& shaders);
  Baker(BakedBy by, gpu::ShaderLibrary& shaders);
  std::unique_ptr<BakeJob> begin(BakeRecipe recipe) const;

  struct Shaders {
    explicit Shaders(gpu::ShaderLibrary& shaders);
    gpu::VolumePass shape, mixed, detail, variation;
    LayerPasses layers;
  };

 private:
  std::optional<Shaders> shaders_;
};

}  // namespace cloudscape::bake
