// The textures of a recipe computed by the processor: the texels of shaders/bake, but for the rounding of their last
// code. For devices that are the processor anyway.
#pragma once
#include "bake/baked_cloudscape.h"
#include "bake/noise_rows.h"

namespace cloudscape::bake {

// A channel of the shape texture, 0..1.
class ChannelRows {
 public:
  ChannelRows(const BakeRecipe& recipe, std::size_t channel);
  void fill(float y, float z, std::span<float> row);

 private:
  float worley_mix_;
  std::optional<WorleyRows> worley_;  // where the mixture has any of it
  std::optional<PerlinRows> perlin_;
  std::vector<float> other_;
};

class ShapeTexels {
 public:
  explicit ShapeTexels(const BakeRecipe& recipe);
  // Layers z_begin <= z < z_end of the texture, into their place in `texels` (as BakedTexels::shape).
  void fill(int z_begin, int z_end, std::vector<std::uint8_t>& texels);

 private:
  void shape_row(int y, float height, std::span<float> shape) const;
  float towers_offset(std::size_t column, float height, float shape) const;
  void store(std::size_t first_texel, std::vector<std::uint8_t>& texels) const;
  const BakeRecipe& recipe_;
  std::vector<ChannelRows> channels_;
  std::array<std::vector<float>, 4> rows_;
  std::vector<float> bells_,
      windows_;  // of the towers by column: share of their height; how much there is near the tile's edge
};

std::vector<std::uint8_t> detail_texels(const BakeRecipe& recipe);
std::vector<std::uint8_t> variation_texels(const BakeRecipe& recipe);

}  // namespace cloudscape::bake
