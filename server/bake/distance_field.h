// The distance field: how far each point of the tile is from the nearest cloud, so that a march can cross clear air in
// as few steps as there are clouds beside it (UHawk, "Rendering volumetric clouds using signed distance fields").
#pragma once
#include "bake/baked_cloudscape.h"
#include "gpu/pass.h"

namespace cloudscape::bake {

class DistanceFieldBuilder {
 public:
  // `most_across`: cells of a tile east and north. tuned: 128 (UHawk) let a march take a tenth less steps than 64, and
  // take four times as long to build, which matters without a GPU.
  DistanceFieldBuilder(gpu::ShaderLibrary& shaders, int most_across);
  glm::ivec3 size_for(const BakedCloudscape& baked) const;  // cells east, north and up
  // RG16F, size_for(baked) cells, level upon level. Red: metres from any point of the cell within which no
  // shape noise is above the level's threshold, nor above what the threshold can fall to on the way; 0 in and beside
  // cloud. Green: metres that the noise less the threshold takes at least to change by 1, within a cell's length of the
  // cell. Built on the device when first asked for, and kept with the baked cloudscape for the last few plans.
  const gpu::Texture& of(const BakedCloudscape& baked, const DistancePlan& plan) const;

 private:
  struct Work;
  gpu::Texture build(const BakedCloudscape& baked, const DistancePlan& plan) const;
  gpu::Texture greatest_shape(const Work& work) const;
  gpu::Texture padded_slopes(Work& work) const;
  gpu::Texture squares(Work& work, const gpu::Texture& greatest_shape) const;
  int most_across_;
  gpu::VolumePass enclose_, pad_, slope_, slope_cells_, seed_, axis_, store_;
};

}  // namespace cloudscape::bake
