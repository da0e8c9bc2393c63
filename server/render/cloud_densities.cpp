#include "render/cloud_densities.h"

#include <algorithm>

#include "render/block_values.h"

namespace cloudscape::render {
namespace {

using gpu::Filter, gpu::Format, gpu::Texture, gpu::Wrap;

constexpr std::size_t most_densities = 4;  // tuned: what the streams of a server look at together; up to 2 MB each

int levels_of(const CloudBlock& cloud) { return static_cast<int>(cloud.in_scatter_scale.w); }

std::vector<vec4> clouds_key(const CloudBlock& cloud) {
  return {cloud.layer,
          cloud.weights,
          cloud.erosion,
          vec4(cloud.shape.y, cloud.tile.x, cloud.tile.y, cloud.volume.y),
          vec4(cloud.march.z, cloud.march.w, cloud.box_low.w, cloud.in_scatter_scale.w),
          vec4(cloud.in_scatter_levels.x, cloud.in_scatter_levels.y, 0, 0)};
}

// An upright, flat tile.
CloudBlock unmoved(CloudBlock cloud) {
  cloud.tile.z = cloud.tile.w = 0;
  cloud.lean = vec4(0);
  cloud.volume.y = 0;
  return cloud;
}

}  // namespace

bool has_cloud_grid(const CloudBlock& cloud, const Cloudscape& sky) {
  return is_textured(sky.volume.kind) && cloud.medium.x > 0 && cloud.march.w > cloud.march.z;
}

Texture cloud_grid_texture(const CloudBlock& cloud, Format format, const GridSize& size, const char* label) {
  Texture texture(format, size.across, size.across, size.layers * levels_of(cloud), label);
  const Wrap wrap = cloud.box_low.w > 0 ? Wrap::repeat : Wrap::clamp;
  texture.sample_with(Filter::linear, wrap, wrap, Wrap::clamp);
  return texture;
}

SunBlock sun_block(const CloudBlock& cloud, const vec4& light) {
  const float low = (cloud.march.z - cloud.layer.x) * cloud.layer.z;
  const float high = (cloud.march.w - cloud.layer.x) * cloud.layer.z;
  const float step = cloud.in_scatter_levels.y > 0 ? 1 / cloud.in_scatter_levels.y : 0;
  return {light, vec4(cloud.in_scatter_levels.x, step, low, high),
          ivec4(CloudDensities::across, CloudDensities::across, CloudDensities::layers, levels_of(cloud))};
}

CloudDensities::CloudDensities(gpu::ShaderLibrary& shaders)
    : pass_(shaders, "render/sun_density.comp"), cloud_block_("cloud in the grid"), block_("grid of the clouds") {}

std::shared_ptr<CloudDensities::Density> CloudDensities::of(const Wanted& wanted) {
  std::vector<vec4> key = clouds_key(wanted.cloud);
  const auto found = std::ranges::find_if(
      densities_, [&](const auto& each) { return each->baked.lock() == wanted.baked && each->key == key; });
  if (found != densities_.end()) {
    densities_.splice(densities_.begin(), densities_, found);
    return densities_.front();
  }
  densities_.push_front(std::make_shared<Density>(
      Density{wanted.baked, std::move(key),
              cloud_grid_texture(wanted.cloud, Format::r32f, {}, "density in the clouds' grid")}));
  if (densities_.size() > most_densities) densities_.pop_back();
  return densities_.front();
}

void CloudDensities::bake_slice(const CloudBlock& cloud, Density& density) {
  cloud_block_.upload(unmoved(cloud)), cloud_block_.bind();
  block_.upload(sun_block(cloud, vec4(0))), block_.bind();
  const auto baked = density.baked.lock();
  const gpu::Binding shape{0, &baked->shape()};
  pass_.run(density.cells, density.next_layer, density.next_layer + layers_per_slice, std::span(&shape, 1));
  density.next_layer += layers_per_slice;
  ++slices_;
}

void CloudDensities::reload(gpu::ShaderLibrary& shaders) {
  pass_ = gpu::VolumePass(shaders, "render/sun_density.comp");
  densities_.clear();
}

}  // namespace cloudscape::render
