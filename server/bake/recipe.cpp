#include "bake/recipe.h"

#include <algorithm>
#include <cmath>

#include "core/content_hash.h"

namespace cloudscape::bake {

glm::ivec3 lattice_cells(const NoiseChannel& channel, double height_over_width) {
  const int up = std::clamp(static_cast<int>(std::lround(channel.frequency * height_over_width)), 1, 256);
  return {channel.frequency, channel.frequency, up};
}

BakeRecipe recipe_alone(const BakeRecipe& recipe, const LayerRecipe& layer) {
  BakeRecipe own = recipe;
  own.seed = layer.seed;
  own.noise = layer.noise;
  own.height_rise = layer.height_rise, own.height_fall = layer.height_fall;
  own.towers = layer.towers;
  return own;
}

glm::ivec2 layer_slices(const LayerRecipe& layer, int resolution) {
  const auto first_above = [&](double height) {
    return std::clamp(static_cast<int>(std::ceil(height * resolution - 0.5)), 0, resolution);
  };
  const int first = first_above(layer.bottom);
  return {first, std::max(0, first_above(layer.top) - first)};
}

int slab_of(int resolution) {
  constexpr int texels = 128 * 128 * 4;
  return std::min(std::max(texels / (resolution * resolution), 4), resolution);
}

float threshold_of(std::vector<float> column_maxima, double coverage) {
  const auto rank = static_cast<std::ptrdiff_t>((1 - coverage) * static_cast<double>(column_maxima.size() - 1));
  std::nth_element(column_maxima.begin(), column_maxima.begin() + rank, column_maxima.end());
  return column_maxima[static_cast<std::size_t>(rank)];
}

BakeRecipe bake_recipe(const Cloudscape& cloudscape, const std::filesystem::path& volumes) {
  BakeRecipe recipe;
  if (cloudscape.volume.kind != VolumeKind::noise) {
    recipe.resolution = recipe.detail_resolution = 1;
    for (NoiseChannel& channel : recipe.noise.channels) channel.octaves = 1;
    recipe.detail_octaves = 1;
    if (!is_from_file(cloudscape.volume.kind)) return recipe;
    recipe.format = ShapeFormat::r16f;
    recipe.grid = grid_recipe(cloudscape.volume, volumes);
    return recipe;
  }
  recipe.seed = cloudscape.seed;
  recipe.resolution = cloudscape.volume.resolution;
  recipe.height_over_width = cloudscape.volume.size_m.z / cloudscape.volume.size_m.x;
  recipe.format = shape_format(cloudscape);
  recipe.detail_resolution = cloudscape.detail.resolution;
  recipe.detail_frequency = cloudscape.detail.frequency;
  recipe.detail_octaves = cloudscape.detail.octaves;
  if (is_layered(cloudscape)) {
    recipe.layers = layer_recipes(cloudscape);
    return recipe;
  }
  recipe.noise = cloudscape.noise;
  if (recipe.format == ShapeFormat::rgba8)
    for (NoiseChannel& channel : recipe.noise.channels) channel.weight = 1;
  recipe.noise.channels[0].weight = 1;  // the shape itself
  recipe.height_rise = cloudscape.shape.height_rise;
  recipe.height_fall = cloudscape.shape.height_fall;
  recipe.towers = cloudscape.shape.towers;
  return recipe;
}

std::string bake_key(const BakeRecipe& recipe) { return content_hash(recipe); }

}  // namespace cloudscape::bake
