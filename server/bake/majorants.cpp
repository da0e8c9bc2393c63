#include "bake/majorants.h"

#include "bake/blocks.h"

namespace cloudscape::bake {
namespace {

using gpu::Binding, gpu::Format, gpu::Texture;

Texture cells(Format format, const glm::ivec3& size, const char* label) {
  Texture texture(format, size.x, size.y, size.z, label);
  texture.sample_with(gpu::Filter::nearest, gpu::Wrap::repeat);
  return texture;
}

}  // namespace

MajorantBuilder::MajorantBuilder(gpu::ShaderLibrary& shaders)
    : enclose_(shaders, "bake/structure.comp"), gather_(shaders, "bake/majorants_coarse.comp") {}

Majorants MajorantBuilder::build(const BakedCloudscape& baked, const std::array<double, 3>& weights) const {
  const glm::ivec3 size = baked.structure_size(), blocks = (size + majorant_block - 1) / majorant_block;
  gpu::UniformBlock<StructureBlock> block("majorants");
  const bool layered = !baked.texels().recipe.layers.empty();
  block.upload({vec4(1, weights[0], weights[1], weights[2]), ivec4(size, baked.shape().width()),
                vec4(majorant_reach, layered, 0, 0)});
  block.bind();
  Majorants majorants{cells(Format::rg32f, size, "majorants"), cells(Format::r32f, blocks, "coarse majorants")};
  const Binding shape[] = {{0, &baked.shape()}}, fine[] = {{0, &majorants.fine}};
  enclose_.run(majorants.fine, 0, size.z, shape);
  gather_.run(majorants.coarse, 0, blocks.z, fine);
  return majorants;
}

}  // namespace cloudscape::bake
