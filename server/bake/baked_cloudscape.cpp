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

std::array<int, 256> histogram_of_column_maxima(const std::vector<std::uint8_t>& shape, int resolution) {
  const std::size_t columns = static_cast<std::size_t>(resolution) * resolution;
  std::vector<std::uint8_t> maxima(columns, 0);
  for (std::size_t texel = 0; texel < shape.size() / 4; ++texel)
    maxima[texel % columns] = std::max(maxima[texel % columns], shape[4 * texel]);
  std::array<int, 256> histogram{};
  for (const std::uint8_t maximum : maxima) ++histogram[maximum];
  return histogram;
}

}  // namespace

BakedCloudscape::BakedCloudscape(const BakedTexels& texels)
    : shape_(uploaded(Format::rgba8, texels.recipe.resolution, texels.recipe.resolution, texels.shape, "shape")),
      detail_(uploaded(Format::rgba8, texels.recipe.detail_resolution, texels.recipe.detail_resolution, texels.detail,
                       "detail")),
      variation_(uploaded(Format::rgba16f, variation_resolution, 1, texels.variation, "variation")),
      column_maxima_(histogram_of_column_maxima(texels.shape, texels.recipe.resolution)) {}

double BakedCloudscape::threshold_for(double coverage) const {
  double columns = 0;
  for (const int count : column_maxima_) columns += count;
  double above = 0;
  for (int level = 255; level >= 0; --level) {
    const double here = column_maxima_[static_cast<std::size_t>(level)];
    if (above + here >= coverage * columns) {
      const double share_of_level = here > 0 ? (coverage * columns - above) / here : 0;
      return (level + 0.5 - share_of_level) / 255.0;
    }
    above += here;
  }
  return 0;
}

}  // namespace cloudscape::bake
