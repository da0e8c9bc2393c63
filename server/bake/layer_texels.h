// Layers of clouds added to one volume of coverage and density, by the processor: the texels of
// shaders/bake/layer_*.comp, but for rounding. For devices that are the processor anyway.
#pragma once
#include "bake/noise_texels.h"

namespace cloudscape::bake {

class LayerTexels {
 public:
  explicit LayerTexels(const BakeRecipe& recipe);
  // Fills the next slices of a layer, or adds them to BakedTexels::shape; true when all layers are in.
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
    std::vector<float> shape, column_maxima;
    int next = 0;                    // slice to fill, of its own
    std::optional<float> threshold;  // once all are filled
    int next_added = 0;              // slice of the volume
  };
  void fill_slices();
  void add_slices(std::vector<std::uint8_t>& texels);
  void add(int z, std::uint8_t* texels) const;
  const BakeRecipe& recipe_;
  std::size_t layer_ = 0;
  std::optional<Work> work_;
};

}  // namespace cloudscape::bake
