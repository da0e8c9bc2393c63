#include "bake/layer_recipe.h"

namespace cloudscape::bake {
namespace {

// Heights in the volume of altitudes; where there is none, of the volume's own bottom and top.
void place(LayerRecipe& recipe, const std::optional<double>& bottom_m, const std::optional<double>& top_m,
           const Volume& volume) {
  const auto height_of = [&](double altitude_m) { return (altitude_m - volume.origin_m.z) / volume.size_m.z; };
  if (bottom_m) recipe.bottom = height_of(*bottom_m);
  if (top_m) recipe.top = height_of(*top_m);
}

// The march's threshold has the mean erosion taken off (shaders/render/medium.glsl), which one that a document gives
// has not.
std::optional<double> own_threshold(const Cloudscape& sky) {
  if (!sky.shape.threshold) return std::nullopt;
  return *sky.shape.threshold + mean_erosion(sky);
}

LayerRecipe own_layer(const Cloudscape& sky) {
  const Shape& shape = sky.shape;
  LayerRecipe recipe;
  recipe.seed = sky.seed;
  recipe.noise = sky.noise;
  recipe.height_rise = shape.height_rise, recipe.height_fall = shape.height_fall;
  recipe.towers = shape.towers;
  recipe.noise.channels[0].weight = 1;  // the shape itself
  recipe.threshold = own_threshold(sky);
  recipe.coverage = recipe.threshold ? 0 : shape.coverage;
  recipe.density = shape.density;
  place(recipe, shape.bottom_m, shape.top_m, sky.volume);
  return recipe;
}

LayerRecipe further_layer(const Cloudscape& sky, std::size_t index) {
  const Layer& layer = sky.layers[index];
  const LayerNoise& noise = layer.noise;
  LayerRecipe recipe;
  recipe.seed = sky.seed + 0x9E3779B9U * static_cast<std::uint32_t>(index + 1);  // Knuth's multiplier: far apart
  for (NoiseChannel& channel : recipe.noise.channels) channel = {0, 1, 1, 2, 0, 0};
  recipe.noise.channels[0] = {noise.worley_mix, noise.frequency, noise.octaves, noise.lacunarity, noise.gain, 1};
  recipe.height_rise = layer.height_rise, recipe.height_fall = layer.height_fall;
  recipe.coverage = layer.coverage, recipe.density = layer.density;
  place(recipe, layer.bottom_m, layer.top_m, sky.volume);
  return recipe;
}

}  // namespace

std::vector<LayerRecipe> layer_recipes(const Cloudscape& cloudscape) {
  std::vector<LayerRecipe> recipes{own_layer(cloudscape)};
  for (std::size_t i = 0; i < cloudscape.layers.size(); ++i) recipes.push_back(further_layer(cloudscape, i));
  return recipes;
}

}  // namespace cloudscape::bake
