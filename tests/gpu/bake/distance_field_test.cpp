// The distance field tells of each cell how far no cloud is, and nearly as far as none is; within cloud, how far all
// is.
#include "bake/distance_field.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>

#include "fixture.h"

namespace cloudscape::bake {
namespace {

struct Field {
  std::vector<double> metres, change_m;
  glm::ivec3 size;
  std::size_t index(const glm::ivec3& cell, int level) const {
    const glm::ivec3 wrapped((cell.x + size.x) % size.x, (cell.y + size.y) % size.y, cell.z + level * size.z);
    return static_cast<std::size_t>((wrapped.z * size.y + wrapped.y) * size.x + wrapped.x);
  }
  double at(const glm::ivec3& cell, int level = 0) const { return metres[index(cell, level)]; }
};

class DistanceField : public BakeTest {
 protected:
  Field built(const BakedCloudscape& baked, const DistancePlan& plan) {
    const std::vector<std::uint8_t> bytes = builder_.of(baked, plan).download();
    Field field{{}, {}, builder_.size_for(baked)};
    for (std::size_t i = 0; i < bytes.size(); i += 4) {
      std::uint16_t halves[2];
      std::memcpy(halves, &bytes[i], 4);
      field.metres.push_back(glm::unpackHalf1x16(halves[0]));
      field.change_m.push_back(glm::unpackHalf1x16(halves[1]));
    }
    return field;
  }
  DistanceFieldBuilder builder_{shaders_, 128};
};

// A tile of 16 x 16 x 16 texels, empty but for some of full noise.
BakedTexels texels_with(const std::vector<std::pair<glm::ivec3, int>>& clouds) {
  BakeRecipe recipe = small_recipe();
  recipe.height_over_width = 1;
  BakedTexels texels{recipe, std::vector<std::uint8_t>(4 * 16 * 16 * 16), std::vector<std::uint8_t>(4 * 16 * 16 * 16),
                     std::vector<std::uint8_t>(8 * variation_resolution * variation_resolution)};
  for (const auto& [at, value] : clouds)
    for (int i = 0; i < 4; ++i)
      texels.shape[static_cast<std::size_t>(4 * ((at.z * 16 + at.y) * 16 + at.x) + i)] =
          static_cast<std::uint8_t>(value);
  return texels;
}

DistancePlan plan_of(double least, double greatest) {
  DistancePlan plan = distance_plan(least, greatest);
  plan.size_m = {1600, 3200, 800};  // cells of 100 x 200 x 50 m
  return plan;
}

// Between the box that interpolation spreads a texel over and a cell: cells between them, along each axis.
glm::dvec3 gap_m(const glm::ivec3& cell, const glm::ivec3& cloud) {
  const auto around = [](int a, int b) { return std::min((a - b + 16) % 16, (b - a + 16) % 16); };
  const glm::ivec3 away(around(cell.x, cloud.x), around(cell.y, cloud.y), std::abs(cell.z - cloud.z));
  return glm::dvec3(glm::max(away - 2, glm::ivec3(0))) * glm::dvec3(100, 200, 50);
}

// In another program; a file that was damaged is built anew, and each plan has one of its own.
TEST_F(DistanceField, ComesBackFromTheDisk) {
  const CacheFolder folder;
  const auto built_with = [&](const DistancePlan& plan) {
    DistanceFieldBuilder builder(shaders_, 128, KeptFiles(folder.path(), 1U << 30));
    const auto baked = std::make_shared<const BakedCloudscape>(texels_with({{{1, 8, 6}, 255}}));
    int stages = 1;
    while (!builder.advance(baked, plan)) ++stages;
    return std::pair(stages, builder.of(*baked, plan).download());
  };
  const auto built = built_with(plan_of(0.3, 0.6));
  EXPECT_GT(built.first, 4);
  EXPECT_EQ(built_with(plan_of(0.3, 0.6)), std::pair(1, built.second));
  ASSERT_EQ(folder.files().size(), 1U);
  std::filesystem::resize_file(folder.path() / folder.files()[0], 100);
  EXPECT_EQ(built_with(plan_of(0.3, 0.6)), built);
  built_with(plan_of(0.3, 0.9));
  EXPECT_EQ(folder.files().size(), 2U);
}

// Frames of others come in between; and of two documents whose fields are built by turns neither gets the other's.
TEST_F(DistanceField, BuiltInStagesIsTheOneBuiltAtOnce) {
  const auto staged = std::make_shared<const BakedCloudscape>(texels_with({{{1, 8, 6}, 255}}));
  const auto other = std::make_shared<const BakedCloudscape>(texels_with({{{4, 4, 9}, 255}}));
  const BakedCloudscape at_once(texels_with({{{1, 8, 6}, 255}}));
  const DistancePlan plan = plan_of(0.3, 0.6);
  int stages = 1;
  while (!builder_.advance(staged, plan)) ++stages, builder_.advance(other, plan);
  EXPECT_GT(stages, 4);
  EXPECT_TRUE(builder_.advance(staged, plan)) << "it is kept";
  EXPECT_EQ(builder_.of(*staged, plan).download(), builder_.of(at_once, plan).download());
  EXPECT_NE(builder_.of(*other, plan).download(), builder_.of(at_once, plan).download());
}

TEST_F(DistanceField, OfOneCloudIsTheGapToItAroundTheTilesEdges) {
  const BakedCloudscape baked(texels_with({{{1, 8, 6}, 255}}));
  const Field field = built(baked, plan_of(0.3, 0.3));
  ASSERT_EQ(field.size, glm::ivec3(16));
  for (int z = 0; z < 16; ++z)
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const double expected = std::min(glm::length(gap_m({x, y, z}, {1, 8, 6})), 800.0);
        ASSERT_NEAR(field.at({x, y, z}), expected, 0.002 * expected) << x << " " << y << " " << z;
        ASSERT_LE(field.at({x, y, z}), expected) << "told too far";
      }
}

// Full noise in a block of texels, first to last.
BakedTexels block_of_cloud(const glm::ivec3& first, const glm::ivec3& last, int value = 255) {
  std::vector<std::pair<glm::ivec3, int>> clouds;
  for (int z = first.z; z <= last.z; ++z)
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x) clouds.push_back({{x, y, z}, value});
  return texels_with(clouds);
}

// Interpolation leaves one cell less on each side that is nothing but cloud.
TEST_F(DistanceField, WithinCloudIsBelowZeroByTheGapToClearAir) {
  const Field field = built(BakedCloudscape(block_of_cloud({4, 4, 3}, {11, 11, 12})), plan_of(0.3, 0.3));
  for (int z = 0; z < 16; ++z)
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const auto deep = [](int at, int first, int last) { return std::max(std::min(at - first, last - at) - 1, -1); };
        const glm::ivec3 cells(deep(x, 4, 11), deep(y, 4, 11), deep(z, 3, 12));
        const double metres = std::min({cells.x * 100, cells.y * 200, cells.z * 50});
        if (glm::min(cells, glm::ivec3(0)) == glm::ivec3(0))
          ASSERT_NEAR(field.at({x, y, z}), -metres, 0.002 * metres) << x << " " << y << " " << z;
        else
          ASSERT_GE(field.at({x, y, z}), 0) << x << " " << y << " " << z;
      }
}

// Above and below the tile all is clear; beside it is the next one.
TEST_F(DistanceField, EndsAtTheTilesTopAndBottom) {
  const Field field = built(BakedCloudscape(block_of_cloud({0, 0, 0}, {15, 15, 15})), plan_of(0.3, 0.3));
  for (const int z : {0, 15}) EXPECT_EQ(field.at({0, 3, z}), 0) << z;
  for (const int z : {2, 13}) EXPECT_NEAR(field.at({0, 3, z}), -100, 0.2) << z;
  EXPECT_NEAR(field.at({8, 8, 8}), -350, 1);
}

// A threshold that rises on the way takes what is only just cloud: of 150 / 255 = 0.59, between the third and the
// fourth level.
TEST_F(DistanceField, WithinCloudReckonsWithAThresholdThatRises) {
  const BakedCloudscape baked(block_of_cloud({0, 0, 0}, {15, 15, 15}, 150));
  DistancePlan plan = plan_of(0.2, 0.7);
  Field field = built(baked, plan);
  EXPECT_NEAR(field.at({8, 8, 8}, 0), -350, 1);
  EXPECT_NEAR(field.at({8, 8, 8}, 1), -350, 1);
  EXPECT_EQ(field.at({8, 8, 8}, 2), 0) << "the threshold may lie above it there";
  plan.threshold_fall_per_m = plan.between_levels / 150;
  field = built(baked, plan);
  EXPECT_NEAR(field.at({8, 8, 8}, 0), -150, 1) << "two levels higher it ends";
  EXPECT_EQ(field.at({8, 8, 8}, 1), 0);
}

// Levels from 0.1875, 9/64 apart: of 0.19, 0.33, 0.47 and 0.61. The weak cloud, of 90 / 255 = 0.35, is in the lower
// two.
const std::vector<std::pair<glm::ivec3, int>> strong_and_weak{{{1, 8, 6}, 255}, {{9, 8, 6}, 90}};

TEST_F(DistanceField, OfAHigherThresholdLeavesOutWhatIsBelowIt) {
  const BakedCloudscape baked(texels_with(strong_and_weak));
  const DistancePlan plan = plan_of(0.2, 0.7);
  ASSERT_EQ(plan.levels, 4);
  const Field field = built(baked, plan);
  EXPECT_EQ(field.at({9, 8, 6}, 0), 0);
  EXPECT_EQ(field.at({9, 8, 6}, 1), 0);
  EXPECT_NEAR(field.at({9, 8, 6}, 2), 600, 1);
}

// The land lowers the threshold by a level in each 150 m: the weak cloud counts as soon as it can have come up.
TEST_F(DistanceField, ReckonsWithAThresholdThatFallsOnTheWay) {
  const BakedCloudscape baked(texels_with(strong_and_weak));
  DistancePlan plan = plan_of(0.2, 0.7);
  plan.threshold_fall_per_m = plan.between_levels / 150;
  const Field field = built(baked, plan);
  EXPECT_EQ(field.at({9, 8, 6}, 2), 0) << "the first fall reaches the level of the weak cloud";
  EXPECT_NEAR(field.at({9, 8, 6}, 3), 150, 1) << "and here the second";
  EXPECT_NEAR(field.at({5, 8, 6}, 3), 200, 1) << "200 m beside either cloud";
  EXPECT_EQ(field.at({1, 8, 6}, 3), 0);
}

// The noise cannot change faster than is told: from a texel of 1 to one of 0, 100 m away, with the product of the
// channels' slopes.
TEST_F(DistanceField, TellsHowFastTheNoiseChanges) {
  const BakedCloudscape baked(texels_with({{{8, 8, 8}, 255}}));
  DistancePlan plan = plan_of(0.3, 0.3);
  const double steepest = glm::length(glm::dvec3(1.0 / 100, 1.0 / 200, 1.0 / 50));  // all along one diagonal
  Field field = built(baked, plan);
  EXPECT_NEAR(field.change_m[field.index({8, 8, 8}, 0)], 1 / steepest, 0.002 / steepest);
  EXPECT_NEAR(field.change_m[field.index({6, 8, 8}, 0)], 1 / steepest, 0.002 / steepest) << "a cell's length away";
  EXPECT_GT(field.change_m[field.index({4, 8, 8}, 0)], 1e4) << "nothing changes there";
  plan.threshold_fall_per_m = 0.01;
  field = built(baked, plan);
  EXPECT_NEAR(field.change_m[field.index({4, 8, 8}, 0)], 100, 1) << "but the threshold";
  plan.jumps = true;
  field = built(baked, plan);
  EXPECT_EQ(field.change_m[field.index({4, 8, 8}, 0)], 0) << "nearest texels jump";
}

// From the box of a cell to a texel's middle, around the tile's edges.
double way_m(const glm::ivec3& cell, const glm::ivec3& texel, const glm::ivec3& size, const glm::dvec3& cell_m) {
  glm::dvec3 gap(0);
  for (int axis = 0; axis < 3; ++axis) {
    double away = std::abs(cell[axis] - texel[axis]);
    if (axis < 2) away = std::min(away, size[axis] - away);
    gap[axis] = std::max(away - 0.5, 0.0) * cell_m[axis];
  }
  return glm::length(gap);
}

// Of baked noise, whose cells are its texels: no texel above the threshold lies within the distance.
TEST_F(DistanceField, OfNoiseHasNoCloudWithinIt) {
  const BakedTexels texels = bake(small_recipe());
  const BakedCloudscape baked(texels);
  DistancePlan plan = distance_plan(0.45, 0.6);
  plan.size_m = {4000, 4000, 1000};
  const Field field = built(baked, plan);
  const glm::ivec3 size = field.size;
  ASSERT_EQ(size, glm::ivec3(16));
  int free = 0, close = 0;
  for (int level = 0; level < plan.levels; ++level) {
    const double threshold = plan.lowest_threshold + level * plan.between_levels;
    std::vector<glm::ivec3> clouds;
    for (int i = 0; i < 16 * 16 * 16; ++i)
      if (texels.shape[4 * static_cast<std::size_t>(i)] / 255.0 > threshold)
        clouds.push_back({i % 16, i / 16 % 16, i / 256});
    ASSERT_GT(clouds.size(), 20u);
    for (int i = 0; i < 16 * 16 * 16; ++i) {
      const glm::ivec3 cell(i % 16, i / 16 % 16, i / 256);
      const double told_m = field.at(cell, level);
      if (told_m == 0) continue;
      double nearest_m = 1e9;
      for (const glm::ivec3& cloud : clouds)
        nearest_m = std::min(nearest_m, way_m(cell, cloud, size, plan.size_m / glm::dvec3(size)));
      ASSERT_LE(told_m, nearest_m) << cell.x << " " << cell.y << " " << cell.z << ", level " << level;
      ++free;
      // Interpolation carries a texel's noise up to the next middles.
      if (told_m > nearest_m - 1.6 * glm::length(plan.size_m / glm::dvec3(size))) ++close;
    }
  }
  EXPECT_GT(free, 100);
  EXPECT_GT(close, free / 2) << "a field that is always near nothing is no use";
}

TEST_F(DistanceField, IsBuiltOnceForEachOfTheLastFewPlans) {
  const BakedCloudscape baked(bake(small_recipe()));
  const gpu::Texture* first = &builder_.of(baked, plan_of(0.3, 0.3));
  const gpu::Texture* second = &builder_.of(baked, plan_of(0.5, 0.5));
  EXPECT_NE(first, second);
  EXPECT_EQ(&builder_.of(baked, plan_of(0.3, 0.3)), first);
  EXPECT_EQ(&builder_.of(baked, plan_of(0.302, 0.3)), first) << "a grain of the threshold is one plan";
}

TEST(DistancePlans, CoverTheirThresholds) {
  for (const double least : {-0.2, 0.1, 0.301})
    for (const double range : {0.0, 0.01, 0.25, 1.0}) {
      const DistancePlan plan = distance_plan(least, least + range);
      EXPECT_LE(plan.lowest_threshold, least);
      EXPECT_GE(plan.lowest_threshold + plan.levels * plan.between_levels, least + range - 1e-9);
      EXPECT_LE(plan.levels, most_distance_levels);
    }
}

}  // namespace
}  // namespace cloudscape::bake
