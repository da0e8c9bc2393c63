#include "bake/distance_field.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "bake/blocks.h"
#include "bake/cells.h"

namespace cloudscape::bake {
namespace {

using gpu::Binding, gpu::Format, gpu::Texture;

// tuned: more than the gap between most clouds; each of its cells is searched.
constexpr int most_searched = 16;

// Thresholds lie on a grid of this fineness, so that a small change of the coverage needs no new field. tuned: what is
// enclosed too much by it is less than what erosion takes away.
constexpr double threshold_grain = 1.0 / 64;

// Around the tile no cell is searched twice; up and down all are.
glm::ivec3 searched(const glm::ivec3& size) {
  return {std::min(size.x / 2, most_searched), std::min(size.y / 2, most_searched), std::min(size.z, most_searched)};
}

// What lies beyond the cells that are searched is at least as far.
double farthest_m(const glm::ivec3& size, const glm::dvec3& cell_m) {
  const glm::ivec3 reach = searched(size);
  const double across = std::min(reach.x * cell_m.x, reach.y * cell_m.y);
  return reach.z < size.z ? std::min(across, reach.z * cell_m.z) : across;
}

}  // namespace

DistancePlan distance_plan(double least, double greatest) {
  DistancePlan plan;
  plan.lowest_threshold = std::floor(least / threshold_grain) * threshold_grain;
  const double range = greatest - plan.lowest_threshold;
  plan.between_levels = threshold_grain * std::max(1.0, std::ceil(range / most_distance_levels / threshold_grain));
  plan.levels = std::clamp(static_cast<int>(std::ceil(range / plan.between_levels)), 1, most_distance_levels);
  return plan;
}

// As fine as the shape, up to so many cells across; 32 up, since layers are flat (UHawk).
glm::ivec3 DistanceFieldBuilder::size_for(const BakedCloudscape& baked) const {
  const gpu::Texture& shape = baked.shape();
  const int most_up = baked.grid() ? most_across_ : 32;
  return glm::min(glm::ivec3(shape.width(), shape.height(), shape.depth()),
                  glm::ivec3(most_across_, most_across_, most_up));
}

DistanceFieldBuilder::DistanceFieldBuilder(gpu::ShaderLibrary& shaders, int most_across)
    : most_across_(most_across),
      enclose_(shaders, "bake/structure.comp"),
      pad_(shaders, "bake/structure_pad.comp"),
      slope_(shaders, "bake/distance_slope.comp"),
      slope_cells_(shaders, "bake/distance_slope_cells.comp"),
      seed_(shaders, "bake/distance_seed.comp"),
      axis_(shaders, "bake/distance_axis.comp"),
      store_(shaders, "bake/distance_store.comp") {}

struct DistanceFieldBuilder::Work {
  const BakedCloudscape& baked;
  const DistancePlan& plan;
  glm::ivec3 size;  // cells
  gpu::UniformBlock<DistanceBlock> block{"distance"};
  DistanceBlock values{ivec4(size, plan.levels),
                       vec4(plan.lowest_threshold, plan.between_levels, 0, 0),
                       ivec4(0),
                       vec4(0, farthest_m(size, cell_m()), plan.threshold_fall_per_m, 0),
                       vec4(1, plan.weights[0], plan.weights[1], plan.weights[2]),
                       vec4(plan.size_m, !plan.jumps)};
  glm::dvec3 cell_m() const { return plan.size_m / glm::dvec3(size); }
  void bind() { block.upload(values), block.bind(); }
};

// Of each cell the greatest shape noise that a look-up in it can find.
Texture DistanceFieldBuilder::greatest_shape(const Work& work) const {
  Texture greatest = cells(Format::rg32f, work.size, "greatest shape");
  gpu::UniformBlock<StructureBlock> block("structure");
  constexpr float reach = 0.01F;  // beyond the faces: a look-up beside one may be taken for the next cell's
  block.upload({work.values.weights, ivec4(work.size, work.baked.shape().width()), vec4(reach, 0, 0, 0)});
  block.bind();
  const Binding shape[] = {{0, &work.baked.shape()}};
  enclose_.run(greatest, 0, work.size.z, shape);
  return greatest;
}

// Of each cell and those about it: how steep the shape noise is.
Texture DistanceFieldBuilder::padded_slopes(Work& work) const {
  work.bind();
  const Texture& shape = work.baked.shape();
  const Texture fine(Format::r32f, shape.width(), shape.height(), shape.depth(), "slopes");
  const Binding texels[] = {{0, &shape}}, slopes[] = {{0, &fine}};
  slope_.run(fine, 0, shape.depth(), texels);
  const Texture own = cells(Format::rg32f, work.size, "slopes");
  slope_cells_.run(own, 0, work.size.z, slopes);
  gpu::UniformBlock<StructureBlock> block("structure");
  block.upload({work.values.weights, ivec4(work.size, 0), vec4(0)});
  block.bind();
  Texture padded = cells(Format::rg32f, work.size, "slopes");
  const Binding unpadded[] = {{0, &own}};
  pad_.run(padded, 0, work.size.z, unpadded);
  return padded;
}

// Of each level in a channel: square of the distance to the nearest cell with cloud, m^2.
Texture DistanceFieldBuilder::squares(Work& work, const Texture& greatest_shape) const {
  Texture now = cells(Format::rgba32f, work.size, "distances"), next = cells(Format::rgba32f, work.size, "distances");
  work.bind();
  const Binding shape[] = {{0, &greatest_shape}};
  seed_.run(now, 0, work.size.z, shape);
  for (int axis = 0; axis < 3; ++axis) {
    work.values.step = ivec4(axis == 0, axis == 1, axis == 2, searched(work.size)[axis]);
    work.values.lengths.x = static_cast<float>(work.cell_m()[axis]);
    work.bind();
    const Binding found[] = {{0, &now}};
    axis_.run(next, 0, work.size.z, found);
    std::swap(now, next);
  }
  return now;
}

Texture DistanceFieldBuilder::build(const BakedCloudscape& baked, const DistancePlan& plan) const {
  Work work{baked, plan, size_for(baked)};
  const Texture slopes = padded_slopes(work), squared = squares(work, greatest_shape(work));
  work.bind();
  const glm::ivec3 all(work.size.x, work.size.y, work.size.z * plan.levels);
  Texture field = cells(Format::rg16f, all, "distance field");
  const Binding found[] = {{0, &squared}, {1, &slopes}};
  store_.run(field, 0, all.z, found);
  return field;
}

const Texture& DistanceFieldBuilder::of(const BakedCloudscape& baked, const DistancePlan& plan) const {
  constexpr std::size_t most = 3;  // documents that differ in nothing but their coverage or the land
  return kept_of(baked.distance_fields_, plan, most, [&] { return build(baked, plan); });
}

}  // namespace cloudscape::bake
