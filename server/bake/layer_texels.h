// Layers of clouds added to one volume of coverage and density, by the processor: the texels of
// shaders/bake/layer_*.comp, but for rounding. For devices that are the processor anyway.
#pragma once
#include "bake/noise_texels.h"

namespace cloudscape::bake {

class LayerTexels {
 public:
  explicit LayerTexels(const BakeRecipe& recipe);
  // The next slices of a layer, or a layer into BakedTexels::shape; true when all are in.
  bool advance(std::vector<std::uint8_t>& texels);
  double progress() const;  // 0..1

 private:
  // The layer at work: its shape, in its own slices alone.
  struct Work {
    Work(const BakeRecipe& recipe, const LayerRecipe& layer);
    const LayerRecipe& layer;
    BakeRecipe alone;
    ShapeRows rows;
    int first, count;  // slices
    std::vector<float> shape;
    int next = 0;
  };
  void fill_slices();
  float threshold() const;
  void add(std::vector<std::uint8_t>& texels) const;
  const BakeRecipe& recipe_;
  std::size_t layer_ = 0;
  std::optional<Work> work_;
};

}  // namespace cloudscape::bake
