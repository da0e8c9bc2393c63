#include "bake/baked_cloudscape.h"

#include <algorithm>
#include <glm/gtc/packing.hpp>

namespace cloudscape::bake {
namespace {

using gpu::Filter, gpu::Format, gpu::Texture, gpu::Wrap;

Texture uploaded(Format format, int width, int depth, const std::vector<std::uint8_t>& texels, const char* label) {
  Texture texture(format, width, width, depth, label);
  texture.sample_with(Filter::linear, Wrap::repeat);
  texture.upload(texels);
  return texture;
}

// The shape that the march sees at a texel (shaders/render/medium.glsl).
float mixed_shape(const std::uint8_t* texel, const std::array<double, 3>& weights) {
  double modulation = 1;
  for (std::size_t i = 0; i < 3; ++i) modulation += weights[i] * (texel[i + 1] / 255.0 - 0.5);
  return static_cast<float>(texel[0] / 255.0 * modulation);
}

float half_at(const std::vector<std::uint8_t>& texels, std::size_t index) {
  return glm::unpackHalf1x16(static_cast<std::uint16_t>(texels[2 * index] | texels[2 * index + 1] << 8));
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

}  // namespace

gpu::Format shape_texture_format(VolumeFormat format) {
  return format == VolumeFormat::r16f ? Format::r16f : Format::rgba8;
}

BakedCloudscape::BakedCloudscape(const BakedTexels& texels)
    : shape_(uploaded(shape_texture_format(texels.recipe.format), texels.recipe.resolution, texels.recipe.resolution,
                      texels.shape, "shape")),
      detail_(uploaded(Format::rgba8, texels.recipe.detail_resolution, texels.recipe.detail_resolution, texels.detail,
                       "detail")),
      variation_(uploaded(Format::rgba16f, variation_resolution, 1, texels.variation, "variation")),
      shape_format_(texels.recipe.format),
      texels_(texels.shape) {}

const BakedCloudscape::Extent& BakedCloudscape::extent(const std::array<double, 3>& weights) const {
  const bool mixed = shape_format_ == VolumeFormat::r16f;
  if (!extent_.slice_maxima.empty() && (mixed || weights == weights_)) return extent_;
  weights_ = weights;
  extent_ =
      mixed ? extent_of(shape_.width(), [&](std::size_t texel) { return half_at(texels_, texel); })
            : extent_of(shape_.width(), [&](std::size_t texel) { return mixed_shape(&texels_[4 * texel], weights); });
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
