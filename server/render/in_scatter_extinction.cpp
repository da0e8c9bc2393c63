#include "render/in_scatter_extinction.h"

#include <algorithm>
#include <cstring>

#include "render/block_values.h"

namespace cloudscape::render {
namespace {

// As many as a work group has: 25 ms on two cores; or, beside frames that do not wait for it, half of that. tuned: with
// one of them no frame is late, and the light of a sun that begins to move takes three seconds to follow.
constexpr int layers_per_slice = 4, layers_per_lagging_slice = 2;

}  // namespace

InScatterExtinction::InScatterExtinction(gpu::ShaderLibrary& shaders)
    : pass_(shaders, "render/in_scatter_extinction.comp"), cloud_("cloud"), block_("in-scatter grid") {}

bool InScatterExtinction::advance(const std::shared_ptr<const Cloudscape>& marched, const bake::BakedCloudscape& baked,
                                  const InScatterPlan& plan, InScatterGrids& grids, Beside beside) const {
  if (grids.done.size() == plan.thresholds.size()) return true;
  const Volume& volume = marched->volume;
  const glm::dvec3 below = glm::dvec3(1, 1, 0) * (volume.origin_m + 0.5 * volume.size_m);
  CloudBlock cloud = cloud_block(seen_by_nobody(marched, below), baked);
  cloud.volume.y = 0;                                                                         // flat
  cloud.shape.x = static_cast<float>(plan.thresholds[grids.done.size()]), cloud.shape.z = 0;  // the same everywhere
  cloud_.upload(cloud);
  cloud_.bind();
  const glm::dvec3 first = volume.origin_m + plan.first * volume.size_m - below, spacing = plan.spacing * volume.size_m;
  block_.upload({vec4(first, 0), vec4(spacing, 0), ivec4(plan.size, 0)});
  block_.bind();
  if (grids.next_layer == 0)
    grids.extinction = gpu::Texture(gpu::Format::r32f, plan.size.x, plan.size.y, plan.size.z, "extinction");
  const gpu::Binding textures[] = {{0, &baked.shape()}, {1, &baked.detail()}, {2, &baked.variation()}};
  const int layers = beside == Beside::lagging ? layers_per_lagging_slice : layers_per_slice;
  const int end = std::min(grids.next_layer + layers, plan.size.z);
  pass_.run(grids.extinction, grids.next_layer, end, textures);
  grids.next_layer = end;
  if (end < plan.size.z) return false;
  grids.next_layer = 0;
  const std::vector<std::uint8_t> bytes = grids.extinction.download();
  bake::InScatterGrid grid{plan.size, spacing, plan.periodic, std::vector<float>(bytes.size() / sizeof(float))};
  std::memcpy(grid.extinction_per_m.data(), bytes.data(), bytes.size());
  grids.done.push_back(std::move(grid));
  return grids.done.size() == plan.thresholds.size();
}

}  // namespace cloudscape::render
