#include "render/sun_depth.h"

#include "render/block_values.h"

namespace cloudscape::render {

SunDepths::SunDepths(gpu::ShaderLibrary& shaders, CloudDensities& densities)
    : volumes_(shaders, densities,
               {.shader = "render/sun_depth.comp",
                .format = gpu::Format::r32f,
                .label = "depth towards the light",
                .across = CloudDensities::across,
                .layers = CloudDensities::layers,
                .layers_per_slice = CloudDensities::layers_per_slice,
                .layers_per_low_slice = CloudDensities::layers_per_slice / 2}) {}

bool SunDepths::prepare(const CloudDensities::Wanted& wanted, std::shared_ptr<const gpu::Texture>& depth) {
  const vec4 light(direction_of_light(*wanted.request.cloudscape), 0);
  return volumes_.prepare(wanted, {light, wanted.cloud.lean}, depth);
}

}  // namespace cloudscape::render
