#include "render/ambient_visibility.h"

namespace cloudscape::render {

bool has_ambient_visibility(const Cloudscape& sky) {
  const LightModelKind kind = sky.medium.light_model.kind;
  return kind != LightModelKind::in_scatter_volume && kind != LightModelKind::olajos;
}

AmbientVisibilities::AmbientVisibilities(gpu::ShaderLibrary& shaders, CloudDensities& densities)
    : volumes_(shaders, densities,
               {.shader = "render/ambient_visibility.comp",
                .format = gpu::Format::rgba32f,
                .label = "visibility of the surroundings",
                .across = across,
                .layers = layers,
                .layers_per_slice = layers_per_slice,
                .layers_per_low_slice = layers_per_slice}) {}

bool AmbientVisibilities::prepare(const CloudDensities::Wanted& wanted,
                                  std::shared_ptr<const gpu::Texture>& visibility) {
  if (!has_ambient_visibility(*wanted.request.cloudscape)) return true;
  const CloudBlock& cloud = wanted.cloud;
  return volumes_.prepare(wanted, {vec4(0), cloud.lean, {cloud.medium.x, cloud.phase.x}}, visibility);
}

}  // namespace cloudscape::render
