#include "bake/distance_field.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "bake/blocks.h"
#include "bake/cells.h"
#include "core/content_hash.h"

namespace cloudscape::bake {
namespace {

using gpu::Binding, gpu::Format, gpu::Texture;

// tuned: more than the gap between most clouds; each of its cells is searched.
constexpr int most_searched = 16;

constexpr std::string_view magic = "cloudscape distance field 1\n";

constexpr std::size_t most_kept = 3;  // fields of documents that differ in nothing but their coverage or the land

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

DistanceFieldBuilder::DistanceFieldBuilder(gpu::ShaderLibrary& shaders, int most_across, KeptFiles files)
    : most_across_(most_across),
      files_(std::move(files)),
      enclose_(shaders, "bake/structure.comp"),
      pad_(shaders, "bake/structure_pad.comp"),
      slope_(shaders, "bake/distance_slope.comp"),
      slope_cells_(shaders, "bake/distance_slope_cells.comp"),
      seed_(shaders, "bake/distance_seed.comp"),
      axis_(shaders, "bake/distance_axis.comp"),
      store_(shaders, "bake/distance_store.comp") {}

struct DistanceFieldBuilder::Work {
  const BakedCloudscape& baked;
  DistancePlan plan;
  glm::ivec3 size;                                      // cells
  std::shared_ptr<const BakedCloudscape> kept_by = {};  // which keeps it while that takes several frames
  int stage = 0;
  Texture slopes = {}, range = {}, squares = {}, spare = {};
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

// Of each cell the greatest and the least shape noise that a look-up in it can find.
void DistanceFieldBuilder::enclose_shape(Work& work) const {
  work.range = cells(Format::rg32f, work.size, "range of the shape");
  gpu::UniformBlock<StructureBlock> block("structure");
  constexpr float reach = 0.01F;  // beyond the faces: a look-up beside one may be taken for the next cell's
  block.upload({work.values.weights, ivec4(work.size, work.baked.shape().width()), vec4(reach, 0, 1, 0)});
  block.bind();
  const Binding shape[] = {{0, &work.baked.shape()}};
  enclose_.run(work.range, 0, work.size.z, shape);
}

// Of each texel: how steep the shape noise is.
void DistanceFieldBuilder::find_slopes(Work& work) const {
  const Texture& shape = work.baked.shape();
  work.slopes = Texture(Format::r32f, shape.width(), shape.height(), shape.depth(), "slopes");
  const Binding texels[] = {{0, &shape}};
  slope_.run(work.slopes, 0, shape.depth(), texels);
}

// Of each cell and those about it.
void DistanceFieldBuilder::pad_slopes(Work& work) const {
  const Texture own = cells(Format::rg32f, work.size, "slopes");
  const Binding slopes[] = {{0, &work.slopes}}, unpadded[] = {{0, &own}};
  slope_cells_.run(own, 0, work.size.z, slopes);
  gpu::UniformBlock<StructureBlock> block("structure");
  block.upload({work.values.weights, ivec4(work.size, 0), vec4(0)});
  block.bind();
  work.slopes = cells(Format::rg32f, work.size, "slopes");
  pad_.run(work.slopes, 0, work.size.z, unpadded);
}

// Of each level in a channel: square of the distance to the nearest cell with cloud, m^2; below 0 within cloud, to the
// nearest with clear air. First of each cell alone.
void DistanceFieldBuilder::begin_squares(Work& work) const {
  work.squares = cells(Format::rgba32f, work.size, "distances");
  work.spare = cells(Format::rgba32f, work.size, "distances");
  const Binding shape[] = {{0, &work.range}};
  seed_.run(work.squares, 0, work.size.z, shape);
}

// Then of those in a row, along one axis after the other.
void DistanceFieldBuilder::spread_squares(Work& work, int axis) const {
  work.values.step = ivec4(axis == 0, axis == 1, axis == 2, searched(work.size)[axis]);
  work.values.lengths.x = static_cast<float>(work.cell_m()[axis]);
  work.bind();
  const Binding found[] = {{0, &work.squares}};
  axis_.run(work.spare, 0, work.size.z, found);
  std::swap(work.squares, work.spare);
}

Texture DistanceFieldBuilder::field_of(Work& work) const {
  const glm::ivec3 all = texels_of(work);
  Texture field = cells(Format::rg16f, all, "distance field");
  const Binding found[] = {{0, &work.squares}, {1, &work.slopes}};
  store_.run(field, 0, all.z, found);
  return field;
}

glm::ivec3 DistanceFieldBuilder::texels_of(const Work& work) {
  return {work.size.x, work.size.y, work.size.z * work.plan.levels};
}

// By all that the field depends on.
std::string DistanceFieldBuilder::name_of(const Work& work) const {
  constexpr const char* version = "3 ";  // of the shaders: raise it when they change what they make
  const std::string across = std::to_string(most_across_);
  return sha256_hex(version + across + bake_key(work.baked.texels().recipe) + content_hash(work.plan)) + ".distance";
}

std::optional<Texture> DistanceFieldBuilder::load(const Work& work) const {
  std::optional<Texture> field;
  files_.load(name_of(work), magic, [&](std::string_view payload) {
    field = cells(Format::rg16f, texels_of(work), "distance field");
    if (payload.size() != field->bytes()) return field.reset(), false;
    field->upload({reinterpret_cast<const std::uint8_t*>(payload.data()), payload.size()});
    return true;
  });
  return field;
}

void DistanceFieldBuilder::store(const Work& work, const Texture& field) const {
  const std::vector<std::uint8_t> texels = field.download();
  files_.store(name_of(work), magic, {reinterpret_cast<const char*>(texels.data()), texels.size()});
}

std::optional<Texture> DistanceFieldBuilder::next_stage(Work& work) const {
  work.bind();
  switch (work.stage++) {
    case 0:
      find_slopes(work);
      break;
    case 1:
      pad_slopes(work);
      break;
    case 2:
      enclose_shape(work);
      break;
    case 3:
      begin_squares(work);
      break;
    case 4:
    case 5:
    case 6:
      spread_squares(work, work.stage - 5);
      break;
    default:
      return field_of(work);
  }
  return std::nullopt;
}

const Texture& DistanceFieldBuilder::of(const BakedCloudscape& baked, const DistancePlan& plan) const {
  return kept_of(baked.distance_fields_, plan, most_kept, [&] {
    Work work{baked, plan, size_for(baked)};
    std::optional<Texture> field;
    while (!(field = next_stage(work))) {
    }
    return std::move(*field);
  });
}

bool DistanceFieldBuilder::advance(const std::shared_ptr<const BakedCloudscape>& baked, const DistancePlan& plan) {
  if (std::ranges::find(baked->distance_fields_, plan, &std::pair<DistancePlan, Texture>::first) !=
      baked->distance_fields_.end())
    return true;
  const auto is_asked = [&](const auto& work) { return work->kept_by == baked && work->plan == plan; };
  auto found = std::ranges::find_if(works_, is_asked);
  if (found == works_.end()) {
    works_.push_front(std::make_shared<Work>(*baked, plan, size_for(*baked), baked));
    found = works_.begin();
    if (works_.size() > most_kept) works_.pop_back();
  }
  std::optional<Texture> field = (*found)->stage == 0 ? load(**found) : std::nullopt;
  if (!field) {
    field = next_stage(**found);
    if (!field) return false;
    store(**found, *field);
  }
  kept_of(baked->distance_fields_, plan, most_kept, [&] { return std::move(*field); });
  works_.erase(found);
  return true;
}

}  // namespace cloudscape::bake
