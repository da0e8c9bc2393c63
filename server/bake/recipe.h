// What a bake depends on, and nothing else: two cloudscapes with equal recipes share their textures.
#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "bake/grid_recipe.h"
#include "bake/layer_recipe.h"
#include "core/bake_size.h"
#include "core/cloudscape.h"

namespace cloudscape::bake {

struct BakeRecipe {
  int version = 4;  // of the baking shaders: raise it when they change what they make
  std::uint32_t seed = 1;
  int resolution = 128;
  ShapeFormat format = ShapeFormat::rgba8;
  double height_over_width = 0.2;  // of the volume: cells of the noise are about as high as wide
  Noise noise;                     // of rgba8 the weights are 1: they matter to the march, not to the bake
  double height_rise = 50, height_fall = 4;
  std::vector<Tower> towers;
  int detail_resolution = 32, detail_frequency = 4, detail_octaves = 3;
  std::vector<LayerRecipe> layers;  // of a layered volume, in place of the noise, heights and towers above
  GridRecipe grid;                  // of a volume from a file, which needs nothing of the above but the format
  bool operator==(const BakeRecipe&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("version", self.version, Limits{}, "");
    visit("seed", self.seed, Limits{}, "");
    visit("resolution", self.resolution, Limits{}, "");
    visit("format", self.format, Limits{}, "");
    visit("height_over_width", self.height_over_width, Limits{}, "");
    visit("noise", self.noise, Limits{}, "");
    visit("height_rise", self.height_rise, Limits{}, "");
    visit("height_fall", self.height_fall, Limits{}, "");
    visit("towers", self.towers, Limits{}, "");
    visit("detail_resolution", self.detail_resolution, Limits{}, "");
    visit("detail_frequency", self.detail_frequency, Limits{}, "");
    visit("detail_octaves", self.detail_octaves, Limits{}, "");
    if (!self.layers.empty()) visit("layers", self.layers, Limits{}, "");  // else keys are what they were without any
    visit("grid", self.grid, Limits{}, "");
  }
};

// Lattice cells of a channel's first octave: whole ones up as well, so that the noise tiles in all three directions.
glm::ivec3 lattice_cells(const NoiseChannel& channel, double height_over_width);

// A layer as a recipe of its own.
BakeRecipe recipe_alone(const BakeRecipe& recipe, const LayerRecipe& layer);
// The slices of the texture whose middles lie between the layer's bottom and its top: the first, and how many.
glm::ivec2 layer_slices(const LayerRecipe& layer, int resolution);

// Slices of the shape that are baked at once. tuned: 50 ms at most on two cores, by llvmpipe, so that a frame rendered
// in between is not late.
int slab_of(int resolution);
// The cut-off above which the share `coverage` of columns holds cloud, of the columns' maxima in any order.
float threshold_of(std::vector<float> column_maxima, double coverage);

// A homogeneous volume needs no noise: its recipe is one texel. `volumes`: the folder of the files that volumes may
// name; empty: none.
BakeRecipe bake_recipe(const Cloudscape& cloudscape, const std::filesystem::path& volumes = {});
std::string bake_key(const BakeRecipe& recipe);  // 64 hexadecimal characters

}  // namespace cloudscape::bake
