// Adds layers of clouds, one after the other and slab by slab, to one volume of coverage and density (UHawk).
#pragma once
#include <optional>
#include <vector>

#include "bake/noise_inputs.h"
#include "gpu/pass.h"

namespace cloudscape::bake {

struct LayerPasses {
  explicit LayerPasses(gpu::ShaderLibrary& shaders);
  gpu::VolumePass shape, columns, add;
};

class LayerJob {
 public:
  LayerJob(const LayerPasses& passes, BakeRecipe recipe);
  bool advance();           // does the next slab; true when all layers are in. Binds a block of its own.
  double progress() const;  // 0..1
  // RG16F, resolution^3. Red: how far each place is in cloud, as a shape that is above `common_threshold` there; of
  // layers in one place the greatest. Green: the density of the layer that is there or nearest, 0..1.
  const gpu::Texture& shape() const { return volume_; }

 private:
  // The layer at work: its noise, in its own slices alone, and then how it is added.
  struct Work {
    Work(const BakeRecipe& recipe, std::size_t index);
    NoiseInputs inputs;
    BakeBlock values;
    double coverage;
    std::optional<double> threshold;
    int count;                    // slices; of none the layer is empty
    gpu::Texture shape, columns;  // R16F; R32F, the greatest of each column
    int next_z = 0;
    bool found = false;  // the threshold
  };
  void shape_slab();
  void find_threshold();
  void add_slab();
  void upload();
  const LayerPasses& passes_;
  BakeRecipe recipe_;
  gpu::Texture volume_;
  gpu::UniformBlock<BakeBlock> block_;
  std::size_t layer_ = 0;
  std::optional<Work> work_;
};

}  // namespace cloudscape::bake
