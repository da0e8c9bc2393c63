#include "bake/noise_inputs.h"

#include <algorithm>
#include <cmath>

#include "bake/permutation.h"

namespace cloudscape::bake {
namespace {

using gpu::Format, gpu::Texture;

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

}  // namespace

NoiseInputs::NoiseInputs(const BakeRecipe& recipe)
    : permutation(permutation_texture(recipe.seed)), towers(tower_texture(recipe.towers)) {}

BakeBlock bake_block(const BakeRecipe& recipe) {
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

}  // namespace cloudscape::bake
