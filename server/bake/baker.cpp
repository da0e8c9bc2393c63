#include "bake/baker.h"

#include <algorithm>
#include <cmath>

#include "bake/blocks.h"
#include "bake/noise_texels.h"
#include "bake/permutation.h"

namespace cloudscape::bake {
namespace {

using gpu::Binding, gpu::Format, gpu::Texture;

Texture table(const std::vector<float>& values, Format format, int width, const char* label) {
  Texture texture(format, width, 1, label);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(values.data());
  texture.upload({bytes, values.size() * sizeof(float)});
  return texture;
}

Texture permutation_texture(std::uint32_t seed) {
  const auto permutation = permutation_table(seed);
  return table({permutation.begin(), permutation.end()}, Format::r32f, 256, "permutation");
}

Texture tower_texture(const std::vector<Tower>& towers) {
  std::vector<float> texels(8 * std::max<std::size_t>(1, towers.size()), 0.0F);
  for (std::size_t i = 0; i < towers.size(); ++i) {
    const Tower& tower = towers[i];
    const double values[] = {tower.center.x, tower.center.y, tower.radius, tower.top, tower.strength};
    std::transform(std::begin(values), std::end(values), texels.begin() + static_cast<std::ptrdiff_t>(8 * i),
                   [](double value) { return static_cast<float>(value); });
  }
  return table(texels, Format::rgba32f, static_cast<int>(texels.size() / 4), "towers");
}

ivec4 lattice_of(const NoiseChannel& channel, double height_over_width) {
  const glm::ivec3 cells = lattice_cells(channel, height_over_width);
  return {cells.x, channel.octaves, channel.lacunarity, cells.z};
}
vec4 blend_of(const NoiseChannel& channel) { return {channel.worley_mix, channel.gain, channel.weight, 0}; }

BakeBlock block_of(const BakeRecipe& recipe) {
  const auto& channels = recipe.noise.channels;
  BakeBlock block;
  block.channel_0 = lattice_of(channels[0], recipe.height_over_width), block.mix_0 = blend_of(channels[0]);
  block.channel_1 = lattice_of(channels[1], recipe.height_over_width), block.mix_1 = blend_of(channels[1]);
  block.channel_2 = lattice_of(channels[2], recipe.height_over_width), block.mix_2 = blend_of(channels[2]);
  block.channel_3 = lattice_of(channels[3], recipe.height_over_width), block.mix_3 = blend_of(channels[3]);
  block.profile = {recipe.height_rise, recipe.height_fall, recipe.towers.size(), 0};
  block.seed = {recipe.seed, 0, 0, 0};
  block.size = ivec4(recipe.resolution);
  block.detail = {recipe.detail_frequency, recipe.detail_octaves, recipe.detail_resolution, 0};
  return block;
}

// tuned: some milliseconds, so that a frame rendered in between is not late.
constexpr int texels_per_slab = 128 * 128 * 4;

int slab_of(int resolution) { return std::clamp(texels_per_slab / (resolution * resolution), 4, resolution); }

class DeviceBake : public BakeJob {
 public:
  DeviceBake(const Baker::Shaders& shaders, BakeRecipe recipe)
      : shaders_(shaders),
        recipe_(std::move(recipe)),
        shape_(shape_texture_format(recipe_.format), recipe_.resolution, recipe_.resolution, recipe_.resolution,
               "shape being baked"),
        detail_(Format::rgba8, recipe_.detail_resolution, recipe_.detail_resolution, recipe_.detail_resolution,
                "detail being baked"),
        variation_(Format::rgba16f, variation_resolution, variation_resolution, 1, "variation being baked"),
        permutation_(permutation_texture(recipe_.seed)),
        towers_(tower_texture(recipe_.towers)),
        block_("bake") {
    block_.upload(block_of(recipe_));
  }

  bool advance() override {
    block_.bind();
    const Binding textures[] = {{0, &permutation_}, {1, &towers_}};
    if (next_z_ == 0) {
      shaders_.detail.run(detail_, 0, recipe_.detail_resolution, textures);
      shaders_.variation.run(variation_, 0, 1, textures);
    }
    const int end = std::min(next_z_ + slab_of(recipe_.resolution), recipe_.resolution);
    (recipe_.format == VolumeFormat::r16f ? shaders_.mixed : shaders_.shape).run(shape_, next_z_, end, textures);
    next_z_ = end;
    return next_z_ >= recipe_.resolution;
  }

  double progress() const override { return static_cast<double>(next_z_) / recipe_.resolution; }
  BakedTexels texels() const override {
    return {recipe_, shape_.download(), detail_.download(), variation_.download()};
  }

 private:
  const Baker::Shaders& shaders_;
  BakeRecipe recipe_;
  gpu::Texture shape_, detail_, variation_, permutation_, towers_;
  gpu::UniformBlock<BakeBlock> block_;
  int next_z_ = 0;
};

class ProcessorBake : public BakeJob {
 public:
  explicit ProcessorBake(BakeRecipe recipe) : texels_{std::move(recipe), {}, {}, {}}, shape_(texels_.recipe) {}

  bool advance() override {
    const BakeRecipe& recipe = texels_.recipe;
    if (next_z_ == 0) texels_.detail = detail_texels(recipe), texels_.variation = variation_texels(recipe);
    const int end = std::min(next_z_ + slab_of(recipe.resolution), recipe.resolution);
    shape_.fill(next_z_, end, texels_.shape);
    next_z_ = end;
    return next_z_ >= recipe.resolution;
  }

  double progress() const override { return static_cast<double>(next_z_) / texels_.recipe.resolution; }
  BakedTexels texels() const override { return texels_; }

 private:
  BakedTexels texels_;
  ShapeTexels shape_;
  int next_z_ = 0;
};

}  // namespace

Baker::Shaders::Shaders(gpu::ShaderLibrary& shaders)
    : shape(shaders, "bake/shape.comp"),
      mixed(shaders, "bake/shape_mixed.comp"),
      detail(shaders, "bake/detail.comp"),
      variation(shaders, "bake/variation.comp") {}

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
