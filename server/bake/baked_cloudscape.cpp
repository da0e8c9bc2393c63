#include "bake/baked_cloudscape.h"

#include <algorithm>

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

std::vector<float> sorted_column_maxima(const std::vector<std::uint8_t>& shape, std::size_t columns,
                                        const std::array<double, 3>& weights) {
  std::vector<float> maxima(columns, 0.0F);
  for (std::size_t texel = 0; texel < shape.size() / 4; ++texel) {
    float& maximum = maxima[texel % columns];
    maximum = std::max(maximum, mixed_shape(&shape[4 * texel], weights));
  }
  std::sort(maxima.begin(), maxima.end());
  return maxima;
}

}  // namespace

BakedCloudscape::BakedCloudscape(const BakedTexels& texels)
    : shape_(uploaded(Format::rgba8, texels.recipe.resolution, texels.recipe.resolution, texels.shape, "shape")),
      detail_(uploaded(Format::rgba8, texels.recipe.detail_resolution, texels.recipe.detail_resolution, texels.detail,
                       "detail")),
      variation_(uploaded(Format::rgba16f, variation_resolution, 1, texels.variation, "variation")),
      texels_(texels.shape) {}

double BakedCloudscape::threshold_for(double coverage, const std::array<double, 3>& weights) const {
  if (column_maxima_.empty() || weights != weights_) {
    const std::size_t columns = static_cast<std::size_t>(shape_.width()) * shape_.height();
    column_maxima_ = sorted_column_maxima(texels_, columns, weights);
    weights_ = weights;
  }
  const double rank = (1 - coverage) * static_cast<double>(column_maxima_.size() - 1);
  return column_maxima_[static_cast<std::size_t>(rank)];
}

}  // namespace cloudscape::bake
