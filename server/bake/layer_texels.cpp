#include "bake/layer_texels.h"

#include <algorithm>
#include <cmath>

#include "bake/halves.h"

namespace cloudscape::bake {
namespace {

// As shaders/bake/layer_add.comp has them.
constexpr float clear = -0.45F, beyond_layer = -1.45F, fall_beyond = 2, blend = 0.05F;

std::size_t columns_of(const BakeRecipe& recipe) {
  return static_cast<std::size_t>(recipe.resolution) * static_cast<std::size_t>(recipe.resolution);
}

}  // namespace

LayerTexels::Work::Work(const BakeRecipe& recipe, const LayerRecipe& of)
    : layer(of),
      alone(recipe_alone(recipe, of)),
      rows(alone),
      first(layer_slices(of, recipe.resolution).x),
      count(layer_slices(of, recipe.resolution).y),
      column_maxima(columns_of(recipe), 0.0F) {}

LayerTexels::LayerTexels(const BakeRecipe& recipe) : recipe_(recipe) {}

void LayerTexels::fill_slices() {
  Work& work = *work_;
  const int side = recipe_.resolution, end = std::min(work.next + slab_of(side), work.count);
  const auto bottom = static_cast<float>(work.layer.bottom), top = static_cast<float>(work.layer.top);
  for (; work.next < end; ++work.next) {
    const float z = middle_of(work.first + work.next, side);
    std::size_t column = 0;
    for (int y = 0; y < side; ++y) {
      work.rows.fill(y, z, (z - bottom) / (top - bottom));
      for (int x = 0; x < side; ++x, ++column) {
        work.shape.push_back(work.rows.mixed(static_cast<std::size_t>(x)));
        work.column_maxima[column] = std::max(work.column_maxima[column], work.shape.back());
      }
    }
  }
}

void LayerTexels::add_slices(std::vector<std::uint8_t>& texels) {
  Work& work = *work_;
  const int side = recipe_.resolution, end = std::min(work.next_added + slab_of(side), side);
  const std::size_t slice_bytes = 4 * columns_of(recipe_);
  texels.resize(slice_bytes * static_cast<std::size_t>(side));
  if (!work.threshold)
    work.threshold = work.layer.threshold ? static_cast<float>(*work.layer.threshold)
                                          : threshold_of(std::move(work.column_maxima), work.layer.coverage);
  for (; work.next_added < end; ++work.next_added)
    add(work.next_added, &texels[static_cast<std::size_t>(work.next_added) * slice_bytes]);
}

void LayerTexels::add(int z, std::uint8_t* texels) const {
  const Work& work = *work_;
  const std::size_t columns = columns_of(recipe_);
  const float height = middle_of(z, recipe_.resolution), density = static_cast<float>(work.layer.density);
  const float beyond =
      std::max({static_cast<float>(work.layer.bottom) - height, height - static_cast<float>(work.layer.top), 0.0F});
  const bool within = z >= work.first && z < work.first + work.count;
  const float* own = within ? &work.shape[static_cast<std::size_t>(z - work.first) * columns] : nullptr;
  for (std::size_t i = 0; i < columns; ++i, texels += 4) {
    const float above = within ? std::max(own[i] - *work.threshold, clear) : beyond_layer - fall_beyond * beyond;
    float shape = static_cast<float>(common_threshold) + above, mixed = density;
    if (layer_ > 0) {
      const float before = half_at(texels), before_density = half_at(texels + 2);
      mixed = std::lerp(before_density, density, smoothstep(-blend, blend, shape - before));
      shape = std::max(before, shape);
    }
    store_half(shape, texels), store_half(mixed, texels + 2);
  }
}

bool LayerTexels::advance(std::vector<std::uint8_t>& texels) {
  if (!work_) work_.emplace(recipe_, recipe_.layers[layer_]);
  if (work_->next < work_->count) {
    fill_slices();
    return false;
  }
  add_slices(texels);
  if (work_->next_added < recipe_.resolution) return false;
  work_.reset();
  return ++layer_ >= recipe_.layers.size();
}

double LayerTexels::progress() const {
  const double share = work_ ? static_cast<double>(work_->next) / std::max(1, work_->count) : 0;
  return std::min(1.0, (static_cast<double>(layer_) + share) / static_cast<double>(recipe_.layers.size()));
}

}  // namespace cloudscape::bake
