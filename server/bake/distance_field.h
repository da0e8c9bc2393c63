// The signed distance field: how far each point of the tile is from the nearest cloud, and (below 0) within cloud from
// clear air. A march crosses clear air by it in as few steps as there are clouds beside it (UHawk, "Rendering
// volumetric clouds using signed distance fields"). Tried: steps in proportion to the depth within cloud. Before a ray
// is so deep that they are longer, what it sees is opaque.
#pragma once
#include <list>
#include <memory>
#include <optional>

#include "bake/baked_cloudscape.h"
#include "bake/kept_files.h"
#include "gpu/pass.h"

namespace cloudscape::bake {

class DistanceFieldBuilder {
 public:
  // `most_across`: cells of a tile east and north. tuned: 128 (UHawk) let a march take a tenth less steps than 64, and
  // take four times as long to build, which matters without a GPU.
  // `files`: where fields are kept from run to run.
  DistanceFieldBuilder(gpu::ShaderLibrary& shaders, int most_across, KeptFiles files = KeptFiles({}, 0));
  glm::ivec3 size_for(const BakedCloudscape& baked) const;  // cells east, north and up
  // RG16F, size_for(baked) cells, level upon level. Red: metres from any point of the cell within which no shape noise
  // is above the level's threshold, nor above what the threshold can fall to on the way; below 0 where all of it is
  // above the next level's threshold, and what that can rise to; 0 at the edges of clouds. Green: metres that the noise
  // less the threshold takes at least to change by 1, within a cell's length of the cell. Built on the device when
  // first asked for, and kept with the baked cloudscape for the last few plans.
  const gpu::Texture& of(const BakedCloudscape& baked, const DistancePlan& plan) const;
  // Does a stage of that, 10 to 60 ms of two cores without a GPU; true: all are done.
  bool advance(const std::shared_ptr<const BakedCloudscape>& baked, const DistancePlan& plan);

 private:
  struct Work;
  // Each does a part of the work; the last one returns the field.
  void enclose_shape(Work& work) const;
  void find_slopes(Work& work) const;
  void pad_slopes(Work& work) const;
  void begin_squares(Work& work) const;
  void spread_squares(Work& work, int axis) const;
  gpu::Texture field_of(Work& work) const;
  std::optional<gpu::Texture> next_stage(Work& work) const;
  static glm::ivec3 texels_of(const Work& work);
  std::string name_of(const Work& work) const;
  std::optional<gpu::Texture> load(const Work& work) const;
  void store(const Work& work, const gpu::Texture& field) const;
  int most_across_;
  KeptFiles files_;
  std::list<std::shared_ptr<Work>> works_;  // fields that are being built, the newest first
  gpu::VolumePass enclose_, pad_, slope_, slope_cells_, seed_, axis_, store_;
};

}  // namespace cloudscape::bake
