#include "bake/structure.h"

#include <algorithm>

#include "bake/blocks.h"

namespace cloudscape::bake {
namespace {

using gpu::Binding, gpu::Format, gpu::Texture;

Texture cells(const glm::ivec3& size, const char* label) {
  Texture texture(Format::rg32f, size.x, size.y, size.z, label);
  texture.sample_with(gpu::Filter::nearest, gpu::Wrap::repeat, gpu::Wrap::repeat, gpu::Wrap::clamp);
  return texture;
}

}  // namespace

StructureBuilder::StructureBuilder(gpu::ShaderLibrary& shaders)
    : enclose_(shaders, "bake/structure.comp"), pad_(shaders, "bake/structure_pad.comp") {}

Texture StructureBuilder::build(const BakedCloudscape& baked, const std::array<double, 3>& weights) const {
  const glm::ivec3 size = baked.structure_size();
  gpu::UniformBlock<StructureBlock> block("structure");
  block.upload({vec4(1, weights[0], weights[1], weights[2]), ivec4(size, baked.shape().width()), vec4(0)});
  block.bind();
  Texture now = cells(size, "structure"), next = cells(size, "structure");
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
  auto& kept = baked.structures_;
  const auto found = std::find_if(kept.begin(), kept.end(), [&](const auto& each) { return each.first == weights; });
  if (found != kept.end()) {
    kept.splice(kept.begin(), kept, found);
  } else {
    constexpr std::size_t most = 4;  // documents that differ in nothing but the weights
    kept.emplace_front(weights, build(baked, weights));
    if (kept.size() > most) kept.pop_back();
  }
  return kept.front().second;
}

}  // namespace cloudscape::bake
