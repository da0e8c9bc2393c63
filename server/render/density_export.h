// The density of a cloudscape in voxels, as the march finds it where its samples lie close together.
#pragma once
#include <array>
#include <vector>

#include "bake/structure.h"
#include "core/frame.h"
#include "gpu/pass.h"
#include "render/blocks.h"

namespace cloudscape::render {

class DensityExport {
 public:
  // The volume's box at time 0, flat, in cubic voxels, `resolution` of them along its longest side. Throws InvalidInput
  // if these are too many.
  DensityExport(gpu::ShaderLibrary& shaders, const Cloudscape& cloudscape, const bake::BakedCloudscape& baked,
                int resolution);
  const glm::ivec3& size() const { return size_; }
  double voxel_m() const { return voxel_m_; }
  const glm::dvec3& low_m() const { return low_m_; }             // corner of the box, world frame
  double extinction_per_m() const { return extinction_per_m_; }  // where density is 1
  static constexpr int slab = 8;                                 // slices that are made at once
  // Densities 0..1 of slices z to z + slab, or to the last; x fastest, then y, then z.
  std::vector<float> slices(int z);

 private:
  glm::dvec3 low_m_{0};
  double voxel_m_ = 1, extinction_per_m_ = 0;
  glm::ivec3 size_{1};
  vec4 corner_{0};
  const bake::BakedCloudscape& baked_;
  bake::StructureBuilder structures_;
  std::array<double, 3> weights_;
  gpu::VolumePass pass_;
  gpu::Texture target_;
  gpu::UniformBlock<CloudBlock> cloud_;
  gpu::UniformBlock<DensityBlock> block_;
};

}  // namespace cloudscape::render
