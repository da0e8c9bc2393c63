#include "bake/layer_job.h"

#include <algorithm>
#include <cstring>

namespace cloudscape::bake {
namespace {

using gpu::Binding, gpu::Format, gpu::Texture;

Texture texture_of(Format format, int resolution, int depth, const char* label) {
  return Texture(format, resolution, resolution, std::max(1, depth), label);
}

std::vector<float> floats_of(const Texture& texture) {
  const std::vector<std::uint8_t> bytes = texture.download();
  std::vector<float> values(bytes.size() / sizeof(float));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

constexpr int added_slabs = 8;  // tuned: to add is so much less work than noise that a slab of it is so much thicker

}  // namespace

LayerPasses::LayerPasses(gpu::ShaderLibrary& shaders)
    : shape(shaders, "bake/layer_shape.comp"),
      columns(shaders, "bake/layer_columns.comp"),
      add(shaders, "bake/layer_add.comp") {}

LayerJob::Work::Work(const BakeRecipe& recipe, std::size_t index)
    : inputs(recipe_alone(recipe, recipe.layers[index])),
      values(bake_block(recipe_alone(recipe, recipe.layers[index]))),
      coverage(recipe.layers[index].coverage),
      threshold(recipe.layers[index].threshold) {
  const LayerRecipe& layer = recipe.layers[index];
  const glm::ivec2 slices = layer_slices(layer, recipe.resolution);
  count = slices.y;
  values.layer = {layer.bottom, layer.top, 0, layer.density};
  values.slices = {slices.x, count, 0, index == 0};
  shape = texture_of(Format::r16f, recipe.resolution, count, "layer");
  columns = texture_of(Format::r32f, recipe.resolution, 1, "columns of a layer");
  columns.clear();
}

LayerJob::LayerJob(const LayerPasses& passes, BakeRecipe recipe)
    : passes_(passes),
      recipe_(std::move(recipe)),
      volume_(texture_of(Format::rg16f, recipe.resolution, recipe.resolution, "layers being baked")),
      block_("layer") {}

void LayerJob::upload() { block_.upload(work_->values), block_.bind(); }

void LayerJob::shape_slab() {
  Work& work = *work_;
  const int end = std::min(work.next_z + slab_of(recipe_.resolution), work.count);
  work.values.slices.z = work.next_z;
  upload();
  const Binding inputs[] = {{0, &work.inputs.permutation}, {1, &work.inputs.towers}}, shape[] = {{0, &work.shape}};
  passes_.shape.run(work.shape, work.next_z, end, inputs);
  work.values.slices.y = end;
  upload();
  passes_.columns.run(work.columns, 0, 1, shape);
  work.values.slices.y = work.count;
  work.next_z = end;
}

void LayerJob::find_threshold() {
  Work& work = *work_;
  work.values.layer.z =
      static_cast<float>(work.threshold ? *work.threshold : threshold_of(floats_of(work.columns), work.coverage));
  work.found = true;
  work.next_z = 0;
}

void LayerJob::add_slab() {
  Work& work = *work_;
  const int end = std::min(work.next_z + added_slabs * slab_of(recipe_.resolution), recipe_.resolution);
  upload();
  const Binding shape[] = {{0, &work.shape}};
  passes_.add.run(volume_, work.next_z, end, shape);
  work.next_z = end;
}

bool LayerJob::advance() {
  if (!work_) work_.emplace(recipe_, layer_);
  if (!work_->found && work_->next_z < work_->count) {
    shape_slab();
    return false;
  }
  if (!work_->found) find_threshold();
  add_slab();
  if (work_->next_z < recipe_.resolution) return false;
  work_.reset();
  return ++layer_ >= recipe_.layers.size();
}

double LayerJob::progress() const {
  double share = 0;  // of the layer at work; nearly all of it is its noise
  if (work_) share = work_->found ? 1.0 : static_cast<double>(work_->next_z) / std::max(1, work_->count);
  return std::min(1.0, (static_cast<double>(layer_) + share) / static_cast<double>(recipe_.layers.size()));
}

}  // namespace cloudscape::bake
