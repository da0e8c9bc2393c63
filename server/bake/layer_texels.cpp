#include "bake/layer_texels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "bake/noise_inputs.h"

namespace cloudscape::bake {
namespace {

std::size_t count(int texels) { return static_cast<std::size_t>(texels); }

float half_at(const std::uint8_t* bytes) {
  std::uint16_t half = 0;
  std::memcpy(&half, bytes, sizeof half);
  return glm::unpackHalf1x16(half);
}

float smoothstep(float low, float high, float value) {
  const float t = std::clamp((value - low) / (high - low), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

// As shaders/bake/layer_add.comp has them.
constexpr float clear = -0.45F, beyond_layer = -1.45F, fall_beyond = 2, blend = 0.05F;

}  // namespace

LayerTexels::Work::Work(const BakeRecipe& recipe, const LayerRecipe& of)
    : layer(of),
      alone(recipe_alone(recipe, of)),
      rows(alone),
      first(layer_slices(of, recipe.resolution).x),
      count(layer_slices(of, recipe.resolution).y) {}

LayerTexels::LayerTexels(const BakeRecipe& recipe) : recipe_(recipe) {}

void LayerTexels::fill_slices() {
  Work& work = *work_;
  const int side = recipe_.resolution, end = std::min(work.next + slab_of(side), work.count);
  const auto bottom = static_cast<float>(work.layer.bottom), top = static_cast<float>(work.layer.top);
  for (; work.next < end; ++work.next)
    for (int y = 0; y < side; ++y) {
      const float z = middle_of(work.first + work.next, side);
      work.rows.fill(y, z, (z - bottom) / (top - bottom));
      for (int x = 0; x < side; ++x) work.shape.push_back(work.rows.mixed(static_cast<std::size_t>(x)));
    }
}

// As BakedCloudscape::threshold_for.
float LayerTexels::threshold() const {
  const Work& work = *work_;
  if (work.layer.threshold) return static_cast<float>(*work.layer.threshold);
  std::vector<float> maxima(bake::count(recipe_.resolution) * bake::count(recipe_.resolution), 0.0F);
  for (std::size_t i = 0; i < work.shape.size(); ++i)
    maxima[i % maxima.size()] = std::max(maxima[i % maxima.size()], work.shape[i]);
  const auto rank = static_cast<std::ptrdiff_t>((1 - work.layer.coverage) * static_cast<double>(maxima.size() - 1));
  std::nth_element(maxima.begin(), maxima.begin() + rank, maxima.end());
  return maxima[static_cast<std::size_t>(rank)];
}

void LayerTexels::add(std::vector<std::uint8_t>& texels) const {
  const Work& work = *work_;
  const int side = recipe_.resolution;
  const std::size_t slice = bake::count(side) * bake::count(side);
  const float cut = threshold(), density = static_cast<float>(work.layer.density);
  texels.resize(4 * slice * bake::count(side));
  for (int z = 0; z < side; ++z) {
    const float height = middle_of(z, side);
    const float beyond =
        std::max({static_cast<float>(work.layer.bottom) - height, height - static_cast<float>(work.layer.top), 0.0F});
    const bool within = z >= work.first && z < work.first + work.count;
    for (std::size_t i = 0; i < slice; ++i) {
      std::uint8_t* texel = &texels[4 * (bake::count(z) * slice + i)];
      const float above = within ? std::max(work.shape[bake::count(z - work.first) * slice + i] - cut, clear)
                                 : beyond_layer - fall_beyond * beyond;
      float shape = static_cast<float>(common_threshold) + above, mixed = density;
      if (layer_ > 0) {
        const float before = half_at(texel), before_density = half_at(texel + 2);
        const float share = smoothstep(-blend, blend, shape - before);
        mixed = before_density + (density - before_density) * share;
        shape = std::max(before, shape);
      }
      store_half(shape, texel), store_half(mixed, texel + 2);
    }
  }
}

bool LayerTexels::advance(std::vector<std::uint8_t>& texels) {
  if (!work_) work_.emplace(recipe_, recipe_.layers[layer_]);
  if (work_->next < work_->count) {
    fill_slices();
    return false;
  }
  add(texels);
  work_.reset();
  return ++layer_ >= recipe_.layers.size();
}

double LayerTexels::progress() const {
  const double share = work_ ? static_cast<double>(work_->next) / std::max(1, work_->count) : 0;
  return std::min(1.0, (static_cast<double>(layer_) + share) / static_cast<double>(recipe_.layers.size()));
}

}  // namespace cloudscape::bake
