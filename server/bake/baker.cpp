#include "bake/baker.h"

#include <algorithm>

namespace cloudscape::bake {
namespace {

using gpu::Binding, gpu::Format;

}  // namespace

Baker::Baker(gpu::ShaderLibrary& shaders)
    : shape_(shaders, "bake/shape.comp"),
      mixed_(shaders, "bake/shape_mixed.comp"),
      detail_(shaders, "bake/detail.comp"),
      variation_(shaders, "bake/variation.comp"),
      layers_(shaders) {}

BakeJob::BakeJob(const Baker& baker, BakeRecipe recipe)
    : baker_(baker),
      recipe_(std::move(recipe)),
      detail_(Format::rgba8, recipe_.detail_resolution, recipe_.detail_resolution, recipe_.detail_resolution,
              "detail being baked"),
      variation_(Format::rgba16f, variation_resolution, variation_resolution, 1, "variation being baked"),
      inputs_(recipe_),
      block_("bake") {
  block_.upload(bake_block(recipe_));
  if (recipe_.layers.empty())
    shape_ = gpu::Texture(shape_texture_format(recipe_.format), recipe_.resolution, recipe_.resolution,
                          recipe_.resolution, "shape being baked");
  else
    layers_.emplace(baker.layers_, recipe_);
}

bool BakeJob::advance() {
  block_.bind();
  const Binding textures[] = {{0, &inputs_.permutation}, {1, &inputs_.towers}};
  if (!begun_) {
    baker_.detail_.run(detail_, 0, recipe_.detail_resolution, textures);
    baker_.variation_.run(variation_, 0, 1, textures);
    begun_ = true;
  }
  if (layers_) return layers_->advance();
  const int end = std::min(next_z_ + slab_of(recipe_.resolution), recipe_.resolution);
  (recipe_.format == ShapeFormat::r16f ? baker_.mixed_ : baker_.shape_).run(shape_, next_z_, end, textures);
  next_z_ = end;
  return next_z_ >= recipe_.resolution;
}

double BakeJob::progress() const {
  return layers_ ? layers_->progress() : static_cast<double>(next_z_) / recipe_.resolution;
}

BakedTexels BakeJob::texels() const {
  return {recipe_, (layers_ ? layers_->shape() : shape_).download(), detail_.download(), variation_.download()};
}

}  // namespace cloudscape::bake
