#include "render/in_scatter_extinction.h"

#include <cstring>

#include "render/block_values.h"

namespace cloudscape::render {

InScatterExtinction::InScatterExtinction(gpu::ShaderLibrary& shaders)
    : pass_(shaders, "render/in_scatter_extinction.comp"), cloud_("cloud"), block_("in-scatter grid") {}

bake::InScatterGrid InScatterExtinction::grid_of(const std::shared_ptr<const Cloudscape>& marched,
                                                 const bake::BakedCloudscape& baked, const InScatterPlan& plan,
                                                 double threshold) const {
  const Volume& volume = marched->volume;
  const glm::dvec3 below = glm::dvec3(1, 1, 0) * (volume.origin_m + 0.5 * volume.size_m);
  CloudBlock cloud = cloud_block(seen_by_nobody(marched, below), baked);
  cloud.volume.y = 0;                                                // flat
  cloud.shape.x = static_cast<float>(threshold), cloud.shape.z = 0;  // the same everywhere
  cloud_.upload(cloud);
  cloud_.bind();
  const glm::dvec3 first = volume.origin_m + plan.first * volume.size_m - below, spacing = plan.spacing * volume.size_m;
  block_.upload({vec4(first, 0), vec4(spacing, 0), ivec4(plan.size, 0)});
  block_.bind();
  const gpu::Texture target(gpu::Format::r32f, plan.size.x, plan.size.y, plan.size.z, "extinction");
  const gpu::Binding textures[] = {{0, &baked.shape()}, {1, &baked.detail()}, {2, &baked.variation()}};
  pass_.run(target, 0, plan.size.z, textures);
  const std::vector<std::uint8_t> bytes = target.download();
  bake::InScatterGrid grid{plan.size, spacing, plan.periodic, std::vector<float>(bytes.size() / sizeof(float))};
  std::memcpy(grid.extinction_per_m.data(), bytes.data(), bytes.size());
  return grid;
}

}  // namespace cloudscape::render
