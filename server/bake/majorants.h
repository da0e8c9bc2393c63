// How dense a cloud can be at most, cell by cell: what delta tracking draws its distances from (Woodcock et al. 1965).
#pragma once
#include <array>

#include "bake/baked_cloudscape.h"
#include "gpu/pass.h"

namespace cloudscape::bake {

// Greatest shape noise of each cell of the structure's grid and of as much beyond its faces as `majorant_reach` says,
// and the greatest density of the layers there (else 1), RG32F; coarse: the noise of each block of `majorant_block`^3
// cells, the last ones cut off, R32F. Repeating east and north.
struct Majorants {
  gpu::Texture fine, coarse;
};
constexpr double majorant_reach = 0.5;  // cells; a march from cell to cell may so find itself a little beyond
constexpr int majorant_block = 8;       // tuned: empty air is crossed in some tens of steps

class MajorantBuilder {
 public:
  explicit MajorantBuilder(gpu::ShaderLibrary& shaders);
  // Where the finer channels of the shape texture are mixed in with `weights`.
  Majorants build(const BakedCloudscape& baked, const std::array<double, 3>& weights) const;

 private:
  gpu::VolumePass enclose_, gather_;
};

}  // namespace cloudscape::bake
