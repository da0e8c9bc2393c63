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

// The four noises of a shape along a row, the first of them formed by heights and towers
// (shaders/bake/shape_noise.glsl).
class ShapeRows {
 public:
  explicit ShapeRows(const BakeRecipe& recipe);
  // The row at `y`, of texels, and `z`, of tiles; `height`: 0..1 of what the heights and towers are of. Channels
  // without weight are left out where the noises are mixed anyway.
  void fill(int y, float z, float height);
  const std::vector<float>& channel(std::size_t i) const { return rows_[i]; }
  // All of them at a texel of the row, mixed by their weights.
  float mixed(std::size_t x) const;

 private:
  float towers_offset(std::size_t column, float height, float shape) const;
  const BakeRecipe& recipe_;
  std::vector<ChannelRows> channels_;
  std::array<std::vector<float>, 4> rows_;
  std::vector<float> bells_,
      windows_;  // of the towers by column: share of their height; how much there is near the tile's edge
};

class ShapeTexels {
 public:
  explicit ShapeTexels(const BakeRecipe& recipe) : recipe_(recipe), rows_(recipe) {}
  bool advance(std::vector<std::uint8_t>& texels);  // the next slices into BakedTexels::shape; true when all are in
  double progress() const { return static_cast<double>(next_z_) / recipe_.resolution; }

 private:
  void store(std::size_t first_texel, std::vector<std::uint8_t>& texels) const;
  const BakeRecipe& recipe_;
  ShapeRows rows_;
  int next_z_ = 0;
};

std::vector<std::uint8_t> detail_texels(const BakeRecipe& recipe);
std::vector<std::uint8_t> variation_texels(const BakeRecipe& recipe);

// The middle of a texel, 0..1 across so many.
constexpr float middle_of(int texel, int texels) {
  return (static_cast<float>(texel) + 0.5F) / static_cast<float>(texels);
}
float smoothstep(float low, float high, float value);  // as GLSL has it

}  // namespace cloudscape::bake
