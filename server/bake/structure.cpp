#include "bake/structure.h"

#include "bake/blocks.h"
#include "bake/cells.h"

namespace cloudscape::bake {

using gpu::Binding, gpu::Format, gpu::Texture;

StructureBuilder::StructureBuilder(gpu::ShaderLibrary& shaders)
    : enclose_(shaders, "bake/structure.comp"), pad_(shaders, "bake/structure_pad.comp") {}

Texture StructureBuilder::build(const BakedCloudscape& baked, const std::array<double, 3>& weights) const {
  const glm::ivec3 size = baked.structure_size();
  gpu::UniformBlock<StructureBlock> block("structure");
  block.upload({vec4(1, weights[0], weights[1], weights[2]), ivec4(size, baked.shape().width()), vec4(0)});
  block.bind();
  Texture now = cells(Format::rg32f, size, "structure"), next = cells(Format::rg32f, size, "structure");
  const Binding shape[] = {{0, &baked.shape()}};
  enclose_.run(now, 0, size.z, shape);
  for (int layer = 0; layer < structure_padding; ++layer) {
    const Binding unpadded[] = {{0, &now}};
    pad_.run(next, 0, size.z, unpadded);
    std::swap(now, next);
  }
  return now;
}

const Texture& StructureBuilder::of(const BakedCloudscape& baked, const std::array<double, 3>& weights) const {
  constexpr std::size_t most = 4;  // documents that differ in nothing but the weights
  return kept_of(baked.structures_, weights, most, [&] { return build(baked, weights); });
}

}  // namespace cloudscape::bake
