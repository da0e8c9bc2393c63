#include "bake/baker.h"

#include <algorithm>

#include "bake/layer_texels.h"
#include "bake/noise_inputs.h"
#include "bake/noise_texels.h"

namespace cloudscape::bake {
namespace {

using gpu::Binding, gpu::Format;

class DeviceBake : public BakeJob {
 public:
  DeviceBake(const Baker::Shaders& shaders, BakeRecipe recipe)
      : shaders_(shaders),
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
      layers_.emplace(shaders.layers, recipe_);
  }

  bool advance() override {
    block_.bind();
    const Binding textures[] = {{0, &inputs_.permutation}, {1, &inputs_.towers}};
    if (!begun_) {
      shaders_.detail.run(detail_, 0, recipe_.detail_resolution, textures);
      shaders_.variation.run(variation_, 0, 1, textures);
      begun_ = true;
    }
    if (layers_) return layers_->advance();
    const int end = std::min(next_z_ + slab_of(recipe_.resolution), recipe_.resolution);
    (recipe_.format == ShapeFormat::r16f ? shaders_.mixed : shaders_.shape).run(shape_, next_z_, end, textures);
    next_z_ = end;
    return next_z_ >= recipe_.resolution;
  }

  double progress() const override {
    return layers_ ? layers_->progress() : static_cast<double>(next_z_) / recipe_.resolution;
  }
  BakedTexels texels() const override {
    return {recipe_, (layers_ ? layers_->shape() : shape_).download(), detail_.download(), variation_.download()};
  }

 private:
  const Baker::Shaders& shaders_;
  BakeRecipe recipe_;
  gpu::Texture shape_, detail_, variation_;
  NoiseInputs inputs_;
  gpu::UniformBlock<BakeBlock> block_;
  std::optional<LayerJob> layers_;  // which bakes the shape where there are several
  bool begun_ = false;
  int next_z_ = 0;
};

class ProcessorBake : public BakeJob {
 public:
  explicit ProcessorBake(BakeRecipe recipe) : texels_{std::move(recipe), {}, {}, {}} {
    if (texels_.recipe.layers.empty())
      shape_.emplace(texels_.recipe);
    else
      layers_.emplace(texels_.recipe);
  }

  bool advance() override {
    const BakeRecipe& recipe = texels_.recipe;
    if (texels_.detail.empty()) texels_.detail = detail_texels(recipe), texels_.variation = variation_texels(recipe);
    return layers_ ? layers_->advance(texels_.shape) : shape_->advance(texels_.shape);
  }

  double progress() const override { return layers_ ? layers_->progress() : shape_->progress(); }
  BakedTexels texels() const override { return texels_; }

 private:
  BakedTexels texels_;
  std::optional<ShapeTexels> shape_;
  std::optional<LayerTexels> layers_;
};

}  // namespace

Baker::Shaders::Shaders(gpu::ShaderLibrary& shaders)
    : shape(shaders, "bake/shape.comp"),
      mixed(shaders, "bake/shape_mixed.comp"),
      detail(shaders, "bake/detail.comp"),
      variation(shaders, "bake/variation.comp"),
      layers(shaders) {}

Baker::Baker(const gpu::Context& context, gpu::ShaderLibrary& shaders)
    : Baker(context.device().software ? BakedBy::processor : BakedBy::device, shaders) {}

Baker::Baker(BakedBy by, gpu::ShaderLibrary& shaders) {
  if (by == BakedBy::device) shaders_.emplace(shaders);
}

std::unique_ptr<BakeJob> Baker::begin(BakeRecipe recipe) const {
  if (shaders_) return std::make_unique<DeviceBake>(*shaders_, std::move(recipe));
  return std::make_unique<ProcessorBake>(std::move(recipe));
}

}  // namespace cloudscape::bake
