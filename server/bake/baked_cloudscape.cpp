#include "bake/baked_cloudscape.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "bake/halves.h"
namespace cloudscape::bake {
namespace {

using gpu::Filter, gpu::Format, gpu::Texture, gpu::Wrap;

Texture uploaded(Format format, int side, const std::vector<std::uint8_t>& texels, const char* label,
                 Wrap up = Wrap::repeat) {
  Texture texture(format, side, side, side, label);
  texture.sample_with(Filter::linear, Wrap::repeat, Wrap::repeat, up);
  texture.upload(texels);
  return texture;
}

Texture shape_texture(const BakedTexels& texels) {
  const Format format = shape_texture_format(texels.recipe.format);
  // The highest layer does not go on below the lowest.
  const Wrap up = texels.recipe.layers.empty() ? Wrap::repeat : Wrap::clamp;
  if (!texels.grid) return uploaded(format, texels.recipe.resolution, texels.shape, "shape", up);
  const glm::ivec3& size = texels.grid->size;
  const GridRecipe& grid = texels.recipe.grid;
  Texture texture(format, size.x, size.y, size.z, "shape");
  const Wrap across = grid.tiling ? Wrap::repeat : Wrap::clamp;
  texture.sample_with(grid.interpolation == VoxelInterpolation::nearest ? Filter::nearest : Filter::linear, across,
                      across, Wrap::clamp);
  texture.upload(texels.shape);
  return texture;
}

// 32 bits and two dimensions: what a software rasterizer samples fastest.
Texture variation_texture(const std::vector<std::uint8_t>& halves) {
  std::vector<std::uint8_t> floats(2 * halves.size());
  for (std::size_t i = 0; i < halves.size() / 2; ++i) {
    const float value = half_at(&halves[2 * i]);
    std::memcpy(&floats[4 * i], &value, sizeof value);
  }
  Texture texture(Format::rgba32f, variation_resolution, variation_resolution, "variation");
  texture.sample_with(Filter::linear, Wrap::repeat);
  texture.upload(floats);
  return texture;
}

// The shape that the march sees at a texel (shaders/render/medium.glsl).
float mixed_shape(const std::uint8_t* texel, const std::array<double, 3>& weights) {
  double modulation = 1;
  for (std::size_t i = 0; i < 3; ++i) modulation += weights[i] * (texel[i + 1] / 255.0 - 0.5);
  return static_cast<float>(texel[0] / 255.0 * modulation);
}

// `value(i)`: the shape at texel i of side^3.
BakedCloudscape::Extent extent_of(int side, auto&& value) {
  const std::size_t columns = static_cast<std::size_t>(side) * side, texels = columns * side;
  BakedCloudscape::Extent extent{std::vector<float>(columns, 0.0F),
                                 std::vector<float>(static_cast<std::size_t>(side), 0.0F)};
  for (std::size_t texel = 0; texel < texels; ++texel) {
    const float shape = value(texel);
    float& column = extent.column_maxima[texel % columns];
    float& slice = extent.slice_maxima[texel / columns];
    column = std::max(column, shape);
    slice = std::max(slice, shape);
  }
  std::sort(extent.column_maxima.begin(), extent.column_maxima.end());
  return extent;
}

// tuned: as many cells as texels, up to 128. Fewer allow longer large steps, but enclose more air: with 64 a march took
// half as many samples again. More are not worth their memory.
glm::ivec3 structure_size_of(const BakedTexels& texels) {
  const BakeRecipe& recipe = texels.recipe;
  if (texels.grid) return glm::min(texels.grid->size, glm::ivec3(128));
  const int side = std::min(recipe.resolution, 128);
  return {side, side, std::clamp(static_cast<int>(std::lround(side * recipe.height_over_width)), 1, 256)};
}

// The greatest difference of neighbouring texels in one channel of the variation map.
double steepest_step(const std::vector<std::uint8_t>& texels, int channel) {
  const auto at = [&](int x, int y) {
    const int texel = (y % variation_resolution) * variation_resolution + x % variation_resolution;
    return static_cast<double>(
        half_at(&texels[8 * static_cast<std::size_t>(texel) + 2 * static_cast<std::size_t>(channel)]));
  };
  double steepest = 0;
  for (int y = 0; y < variation_resolution; ++y)
    for (int x = 0; x < variation_resolution; ++x)
      steepest = std::max({steepest, std::abs(at(x + 1, y) - at(x, y)), std::abs(at(x, y + 1) - at(x, y))});
  return steepest;
}

// Slopes along both axes at once, and of both shifts at once, are at most the square root of two as steep.
BakedCloudscape::Slopes slopes_of(const std::vector<std::uint8_t>& variation) {
  const double per_period = std::sqrt(2.0) * variation_resolution;
  const double shift = std::max(steepest_step(variation, 1), steepest_step(variation, 2));
  return {per_period * steepest_step(variation, 0), std::sqrt(2.0) * per_period * shift};
}

}  // namespace

gpu::Format shape_texture_format(ShapeFormat format) {
  constexpr Format formats[] = {Format::rgba8, Format::r16f, Format::rg16f};
  return formats[static_cast<std::size_t>(format)];
}

BakedCloudscape::BakedCloudscape(BakedTexels texels)
    : shape_(shape_texture(texels)),
      detail_(uploaded(Format::rgba8, texels.recipe.detail_resolution, texels.detail, "detail")),
      variation_(variation_texture(texels.variation)),
      texels_(std::move(texels)),
      structure_size_(structure_size_of(texels_)),
      steepest_variation_(slopes_of(texels_.variation)) {
  if (!texels_.grid) return;
  extent_.slice_maxima = texels_.grid->slice_maxima;
  texels_.shape = {};
}

const BakedCloudscape::Extent& BakedCloudscape::extent(const std::array<double, 3>& weights) const {
  const std::vector<std::uint8_t>& shape = texels_.shape;
  const bool mixed = texels_.recipe.format != ShapeFormat::rgba8;
  const std::size_t channels = texels_.recipe.format == ShapeFormat::rg16f ? 2 : 1;
  if (!extent_.slice_maxima.empty() && (mixed || weights == weights_)) return extent_;
  weights_ = weights;
  extent_ = mixed
                ? extent_of(shape_.width(), [&](std::size_t texel) { return half_at(&shape[2 * channels * texel]); })
                : extent_of(shape_.width(), [&](std::size_t texel) { return mixed_shape(&shape[4 * texel], weights); });
  return extent_;
}

double BakedCloudscape::threshold_for(double coverage, const std::array<double, 3>& weights) const {
  const std::vector<float>& maxima = extent(weights).column_maxima;
  return maxima[static_cast<std::size_t>((1 - coverage) * static_cast<double>(maxima.size() - 1))];
}

HeightRange heights_above(const BakedCloudscape::Extent& extent, double threshold) {
  const auto exceeds = [threshold](float maximum) { return maximum > threshold; };
  const auto& slices = extent.slice_maxima;
  const auto first = std::find_if(slices.begin(), slices.end(), exceeds);
  if (first == slices.end()) return {1, 0};
  const auto last = std::find_if(slices.rbegin(), slices.rend(), exceeds);
  // Between slices the texture is interpolated: half a texel beyond the neighbour's middle, and around the edge.
  const double texel = 1.0 / static_cast<double>(slices.size());
  const double low = static_cast<double>(first - slices.begin()) * texel - 0.5 * texel;
  const double high = static_cast<double>(slices.rend() - last) * texel + 0.5 * texel;
  return {std::max(0.0, low), std::min(1.0, high)};
}

}  // namespace cloudscape::bake
