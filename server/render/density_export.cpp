#include "render/density_export.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/error.h"
#include "core/voxels.h"
#include "render/block_values.h"

namespace cloudscape::render {
namespace {

// tuned: 4 GiB as floats, which OpenVDB keeps where they are not 0.
constexpr double most_voxels = 1 << 30;

}  // namespace

DensityExport::DensityExport(gpu::ShaderLibrary& shaders, const Cloudscape& cloudscape,
                             const bake::BakedCloudscape& baked, int resolution)
    : baked_(baked),
      structures_(shaders),
      weights_(mixing_weights(cloudscape)),
      pass_(shaders, "render/density.comp"),
      cloud_("cloud"),
      block_("density") {
  const auto shared = std::make_shared<const Cloudscape>(cloudscape);
  const Cloudscape sky = *as_marched(seen_by_nobody(shared, glm::dvec3(0)), baked).cloudscape;
  const glm::dvec3 size_m = sky.volume.size_m;
  low_m_ = sky.volume.origin_m;
  voxel_m_ = std::max({size_m.x, size_m.y, size_m.z}) / resolution;
  size_ = glm::max(glm::ivec3(glm::ceil(size_m / voxel_m_ - 1e-6)), glm::ivec3(1));
  if (static_cast<double>(count_of(size_)) > most_voxels)
    throw InvalidInput("--vdb-resolution",
                       "asks for " + std::to_string(count_of(size_) >> 20) + " million voxels: 1024 million at most");
  target_ = gpu::Texture(gpu::Format::r32f, size_.x, size_.y, slab, "density");
  const glm::dvec3 below(low_m_.x + 0.5 * size_m.x, low_m_.y + 0.5 * size_m.y, 0);
  CloudBlock block = cloud_block(seen_by_nobody(shared, below), baked);
  block.volume.y = 0;  // flat
  extinction_per_m_ = sky.medium.extinction_per_m;
  cloud_.upload(block);
  corner_ = vec4(low_m_ - below, voxel_m_);
}

std::vector<float> DensityExport::slices(int z) {
  const int count = std::min(slab, size_.z - z);
  const gpu::Texture& structure = structures_.of(baked_, weights_);
  block_.upload({corner_, ivec4(size_, z)});
  cloud_.bind();
  block_.bind();
  const gpu::Binding textures[] = {
      {0, &baked_.shape()}, {1, &baked_.detail()}, {2, &baked_.variation()}, {4, &structure}};
  pass_.run(target_, 0, count, textures);
  const std::vector<std::uint8_t> bytes = target_.download();
  std::vector<float> densities(count_of({size_.x, size_.y, count}));
  std::memcpy(densities.data(), bytes.data(), densities.size() * sizeof(float));
  return densities;
}

}  // namespace cloudscape::render
