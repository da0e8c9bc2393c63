#include "bake/recipe.h"

#include "core/content_hash.h"

namespace cloudscape::bake {

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
