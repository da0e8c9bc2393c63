#include "bake/noise_texels.h"

#include <algorithm>
#include <cmath>

#include "bake/halves.h"
#include "bake/permutation.h"

namespace cloudscape::bake {
namespace {

std::size_t count(int texels) { return static_cast<std::size_t>(texels); }
float mix(float a, float b, float share) { return a + (b - a) * share; }

// Spreads [low, high] over [0, 1], as shaders/lib/shape.glsl.
float stretch(float value, float low, float high) { return std::clamp((value - low) / (high - low), 0.0F, 1.0F); }
float stretched_worley(float value) { return stretch(value, 0.3F, 0.95F); }
float stretched_perlin(float value) { return stretch(value, 0.25F, 0.75F); }

std::uint8_t code(float value) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0F, 1.0F))); }

Fbm fbm_of(const NoiseChannel& channel, double height_over_width) {
  return {lattice_cells(channel, height_over_width), channel.octaves, channel.lacunarity,
          static_cast<float>(channel.gain)};
}

float height_distribution(float h, float a, float b) { return (1 - std::exp(-a * h)) * std::exp(-b * h); }

// shaders/lib/shape.glsl
float tile_window(float x, float y) { return smoothstep(0, 0.08F, std::min({x, 1 - x, y, 1 - y})); }

}  // namespace

float smoothstep(float low, float high, float value) {
  const float t = std::clamp((value - low) / (high - low), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

ChannelRows::ChannelRows(const BakeRecipe& recipe, std::size_t channel)
    : worley_mix_(static_cast<float>(recipe.noise.channels[channel].worley_mix)), other_(count(recipe.resolution)) {
  const Fbm fbm = fbm_of(recipe.noise.channels[channel], recipe.height_over_width);
  const auto salt = static_cast<std::uint32_t>(channel);
  if (worley_mix_ > 0) worley_.emplace(fbm, recipe.seed * 16 + salt, recipe.resolution);
  if (worley_mix_ < 1) perlin_.emplace(fbm, permutation_table(recipe.seed));
}

void ChannelRows::fill(float y, float z, std::span<float> row) {
  std::ranges::fill(row, 0.0F);
  if (worley_) worley_->fill(y, z, row);
  for (float& value : row) value = stretched_worley(value);
  if (!perlin_) return;
  perlin_->fill(y, z, other_);
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = mix(stretched_perlin(other_[i]), row[i], worley_mix_);
}

ShapeRows::ShapeRows(const BakeRecipe& recipe) : recipe_(recipe) {
  const int side = recipe.resolution;
  for (std::size_t i = 0; i < 4; ++i) {
    channels_.emplace_back(recipe, i);
    rows_[i].resize(count(side));
  }
  for (int texel = 0; texel < side * side; ++texel) {
    const float x = middle_of(texel % side, side), y = middle_of(texel / side, side);
    windows_.push_back(tile_window(x, y));
    for (const Tower& tower : recipe.towers) {
      const auto radius = static_cast<float>(tower.radius);
      const float east = x - static_cast<float>(tower.center.x), north = y - static_cast<float>(tower.center.y);
      bells_.push_back(std::exp(-(east * east + north * north) / (2 * radius * radius)));
    }
  }
}

// shaders/bake/shape_noise.glsl, with tower_offset of shaders/lib/shape.glsl.
float ShapeRows::towers_offset(std::size_t column, float height, float shape) const {
  const std::size_t towers = recipe_.towers.size();
  const float pushed = height / mix(0.45F, 1.3F, shape);
  float offset = 0;
  for (std::size_t i = 0; i < towers; ++i) {
    const Tower& tower = recipe_.towers[i];
    const float bell = bells_[column * towers + i];
    const float below = std::clamp((static_cast<float>(tower.top) * bell - pushed) / 0.2F, 0.0F, 1.0F);
    offset += static_cast<float>(tower.strength) * bell * below;
  }
  if (offset == 0) return 0;
  const float base = 1 - std::exp(-50 * pushed);
  return offset * base * windows_[column] * mix(0.35F, 1.0F, shape);
}

void ShapeRows::fill(int y, float z, float height) {
  const auto& channels = recipe_.noise.channels;
  const int side = recipe_.resolution;
  for (std::size_t i = 0; i < 4; ++i)
    if (i == 0 || recipe_.format == ShapeFormat::rgba8 || channels[i].weight > 0)
      channels_[i].fill(middle_of(y, side), z, rows_[i]);
  const float distribution =
      height_distribution(height, static_cast<float>(recipe_.height_rise), static_cast<float>(recipe_.height_fall));
  const std::size_t first_column = count(y) * count(side);
  for (std::size_t x = 0; x < count(side); ++x) {
    float& shape = rows_[0][x];
    shape = shape * distribution + towers_offset(first_column + x, height, shape);
  }
}

float ShapeRows::mixed(std::size_t x) const {
  float factor = 1;
  for (std::size_t i = 1; i < 4; ++i)
    factor += static_cast<float>(recipe_.noise.channels[i].weight) * (rows_[i][x] - 0.5F);
  return std::clamp(rows_[0][x], 0.0F, 1.0F) * factor;
}

void ShapeTexels::store(std::size_t first_texel, std::vector<std::uint8_t>& texels) const {
  for (std::size_t x = 0; x < count(recipe_.resolution); ++x) {
    const std::size_t texel = first_texel + x;
    if (recipe_.format == ShapeFormat::rgba8)
      for (std::size_t i = 0; i < 4; ++i) texels[4 * texel + i] = code(rows_.channel(i)[x]);
    else
      store_half(rows_.mixed(x), &texels[2 * texel]);
  }
}

bool ShapeTexels::advance(std::vector<std::uint8_t>& texels) {
  const int side = recipe_.resolution, end = std::min(next_z_ + slab_of(side), side);
  texels.resize(count(side) * count(side) * count(side) * count(bytes_per_texel(recipe_.format)));
  for (; next_z_ < end; ++next_z_)
    for (int y = 0; y < side; ++y) {
      rows_.fill(y, middle_of(next_z_, side), middle_of(next_z_, side));
      store((count(next_z_) * count(side) + count(y)) * count(side), texels);
    }
  return next_z_ >= side;
}

// shaders/bake/detail.comp
std::vector<std::uint8_t> detail_texels(const BakeRecipe& recipe) {
  const int side = recipe.detail_resolution;
  const Fbm fbm{glm::ivec3(recipe.detail_frequency), recipe.detail_octaves, 2, 0.5F};
  WorleyRows worley(fbm, recipe.seed * 16 + 9, side);
  const PerlinRows perlin(fbm, permutation_table(recipe.seed));
  std::vector<float> billows(count(side)), wisps(count(side));
  std::vector<std::uint8_t> texels;
  for (int row = 0; row < side * side; ++row) {
    worley.fill(middle_of(row % side, side), middle_of(row / side, side), billows);
    perlin.fill(middle_of(row % side, side), middle_of(row / side, side), wisps);
    for (std::size_t x = 0; x < count(side); ++x)
      texels.insert(texels.end(), {code(stretched_worley(billows[x])), code(stretched_perlin(wisps[x])), 0, 255});
  }
  return texels;
}

// shaders/bake/variation.comp
std::vector<std::uint8_t> variation_texels(const BakeRecipe& recipe) {
  const PerlinRows perlin({glm::ivec3(4), 3, 2, 0.5F}, permutation_table(recipe.seed));
  std::vector<std::uint8_t> texels(count(variation_resolution) * count(variation_resolution) * 8);
  std::vector<float> row(count(variation_resolution));
  const auto store = [&](int y, std::size_t channel, float value, std::size_t x) {
    store_half(value, &texels[8 * (count(y) * row.size() + x) + 2 * channel]);
  };
  for (int y = 0; y < variation_resolution; ++y)
    for (std::size_t channel = 0; channel < 4; ++channel) {
      if (channel < 3) perlin.fill(middle_of(y, variation_resolution), 0.1F + 0.3F * static_cast<float>(channel), row);
      for (std::size_t x = 0; x < row.size(); ++x)
        store(y, channel, channel < 3 ? stretch(row[x], 0.3F, 0.7F) : 1.0F, x);
    }
  return texels;
}

}  // namespace cloudscape::bake
