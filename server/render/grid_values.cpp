// A volume from a file as the march sees it.
#include <algorithm>

#include "core/error.h"
#include "render/block_values.h"

namespace cloudscape::render {
namespace {

constexpr double farthest_m = 1e7, smallest_m = 1, largest_m = 1e6;  // as of volume.origin_m and size_m

// A .vdb says where it is; a .raw or .exr does not.
void place(Volume& volume, const bake::GridFacts& facts) {
  const VolumeGrid& grid = volume.grid;
  if (volume.kind != VolumeKind::vdb || grid.placement == GridPlacement::box) return;
  volume.origin_m = facts.low * grid.metres_per_unit + grid.offset_m;
  volume.size_m = (facts.high - facts.low) * grid.metres_per_unit;
  for (int axis = 0; axis < 3; ++axis) {
    const double size_m = volume.size_m[axis];
    if (!(size_m >= smallest_m && size_m <= largest_m))
      throw UnusableFile("the volume '" + grid.file + "' would be " + std::to_string(size_m) +
                         " m wide: correct volume.grid.metres_per_unit, or place it in a box");
    if (!(std::abs(volume.origin_m[axis]) <= farthest_m))
      throw UnusableFile("the volume '" + grid.file +
                         "' would be more than 10000 km away: correct volume.grid.offset_m");
  }
}

}  // namespace

FrameRequest as_marched(const FrameRequest& request, const bake::BakedCloudscape& baked) {
  if (!baked.grid()) return request;
  auto sky = std::make_shared<Cloudscape>(*request.cloudscape);
  place(sky->volume, *baked.grid());
  sky->volume.tiling = sky->volume.grid.tiling;
  sky->volume.format = VolumeFormat::r16f;
  sky->shape = {};
  sky->shape.threshold = 0, sky->shape.edge_softness = 1;
  sky->detail.strength = 0;
  sky->medium.extinction_per_m *= sky->volume.grid.density_scale * baked.grid()->greatest_density;
  FrameRequest marched = request;
  marched.cloudscape = std::move(sky);
  return marched;
}

}  // namespace cloudscape::render
