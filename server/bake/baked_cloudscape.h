// A baked cloudscape: the texels, as the cache keeps them, and the textures that the march samples.
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <list>
#include <optional>
#include <utility>
#include <vector>

#include "bake/distance_plan.h"
#include "bake/recipe.h"
#include "gpu/texture.h"

namespace cloudscape::bake {

// What a volume's file said of its voxels.
struct GridFacts {
  glm::ivec3 size{1};
  double greatest_density = 1;      // the shape texture holds shares of it
  glm::dvec3 low{0}, high{0};       // the box of the voxels in the file's units; equal where the file has no place
  std::vector<float> slice_maxima;  // shares, bottom to top
  bool operator==(const GridFacts&) const = default;
};

// Texels of the three textures, x fastest, then y, then z (bottom to top).
struct BakedTexels {
  BakeRecipe recipe;
  std::vector<std::uint8_t> shape;      // RGBA8, R16F or RG16F as the recipe says, resolution^3 or the grid's size
  std::vector<std::uint8_t> detail;     // RGBA8, detail_resolution^3
  std::vector<std::uint8_t> variation;  // RGBA16F, variation_resolution^2
  std::optional<GridFacts> grid = {};   // of a volume from a file
  bool operator==(const BakedTexels&) const = default;
};

constexpr int structure_padding = 2;  // cells around the clouds: the double padding of Olajos 2.4.2
gpu::Format shape_texture_format(ShapeFormat format);
// The shape of several layers is above this where there is cloud, by as much as each layer's noise is above the
// threshold that its own coverage gives (shaders/bake/layer_add.comp).
constexpr double common_threshold = 0.5;

class BakedCloudscape {
 public:
  explicit BakedCloudscape(BakedTexels texels);
  const BakedTexels& texels() const { return texels_; }  // of a volume from a file, without the shape
  const std::optional<GridFacts>& grid() const { return texels_.grid; }
  const gpu::Texture& shape() const { return shape_; }
  const gpu::Texture& detail() const { return detail_; }
  const gpu::Texture& variation() const { return variation_; }
  // How the march sees the shape where it mixes the finer channels in with `weights`; remembered for the last weights.
  // A shape of one channel is mixed already, as that of several layers is: its weights change nothing.
  struct Extent {
    std::vector<float> column_maxima;  // greatest value of each column, ascending
    std::vector<float> slice_maxima;   // of each slice, bottom to top
  };
  const Extent& extent(const std::array<double, 3>& weights) const;
  // The cut-off above which the share `coverage` of the tile's columns holds cloud, in units of the shape channel.
  double threshold_for(double coverage, const std::array<double, 3>& weights) const;
  glm::ivec3 structure_size() const { return structure_size_; }  // cells east, north and up, about as high as wide
  // The steepest slopes of the variation map, per period: of what changes the threshold, and of what shifts the tile.
  struct Slopes {
    double threshold = 0, shift = 0;
  };
  Slopes steepest_variation() const { return steepest_variation_; }
  std::size_t bytes() const { return shape_.bytes() + detail_.bytes() + variation_.bytes(); }

 private:
  friend class StructureBuilder;
  friend class DistanceFieldBuilder;
  gpu::Texture shape_, detail_, variation_;
  BakedTexels texels_;
  mutable std::array<double, 3> weights_{};
  mutable Extent extent_;
  glm::ivec3 structure_size_{1};
  Slopes steepest_variation_;
  // Most recently used first:
  mutable std::list<std::pair<std::array<double, 3>, gpu::Texture>> structures_;
  mutable std::list<std::pair<DistancePlan, gpu::Texture>> distance_fields_;
};

struct HeightRange {
  double low = 0, high = 1;  // 0..1 of the volume
};
// The heights between which any value can exceed the threshold; empty (low > high) where none does.
HeightRange heights_above(const BakedCloudscape::Extent& extent, double threshold);

}  // namespace cloudscape::bake
