// Several layers in one volume: each between its altitudes, of its coverage and density, and the same at every bake.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "bake/cache.h"
#include "bake/distance_field.h"
#include "bake/majorants.h"
#include "bake/structure.h"
#include "core/bake_size.h"
#include "fixture.h"

namespace cloudscape::bake {
namespace {

constexpr int side = 32;

// Heaps from 1000 to 2500 m, a thin deck from 3500 to 4000 m and shreds at 1250 to 1750 m, among the heaps: slices 0 to
// 11, 20 to 23 and 2 to 5.
Cloudscape three_layers() {
  Cloudscape sky;
  sky.seed = 4;
  sky.volume.origin_m = {0, 0, 1000}, sky.volume.size_m = {8000, 8000, 4000};
  sky.volume.resolution = side, sky.detail.resolution = 16;
  for (NoiseChannel& channel : sky.noise.channels) channel.frequency = 4, channel.octaves = 2;
  sky.shape.top_m = 2500;
  sky.shape.coverage = 0.4;
  sky.shape.height_fall = 1;
  sky.layers = {Layer{}, Layer{}};
  sky.layers[0].bottom_m = 3500, sky.layers[0].top_m = 4000;
  sky.layers[0].coverage = 0.7, sky.layers[0].density = 0.25;
  sky.layers[1].bottom_m = 1250, sky.layers[1].top_m = 1750;
  sky.layers[1].coverage = 0.2, sky.layers[1].density = 0.5;
  for (Layer& layer : sky.layers) layer.noise.frequency = 8, layer.noise.octaves = 2;
  return sky;
}

struct Texel {
  double shape, density;
  bool cloud() const { return shape > common_threshold; }
};

// Of x, y and z as they follow one another in the texture.
std::vector<Texel> texels_of(const std::vector<std::uint8_t>& shape) {
  std::vector<Texel> texels;
  const std::vector<std::uint16_t> halves = gpu::as_numbers<std::uint16_t>(shape);
  for (std::size_t i = 0; i < halves.size(); i += 2)
    texels.push_back({glm::unpackHalf1x16(halves[i]), glm::unpackHalf1x16(halves[i + 1])});
  return texels;
}

// Share of columns with cloud in slices from `first` to before `last`.
double coverage_of(const std::vector<Texel>& texels, int first, int last) {
  constexpr std::size_t columns = side * side;
  int cloudy = 0;
  for (std::size_t column = 0; column < columns; ++column) {
    bool cloud = false;
    for (int z = first; z < last; ++z) cloud = cloud || texels[static_cast<std::size_t>(z) * columns + column].cloud();
    cloudy += cloud ? 1 : 0;
  }
  return cloudy / static_cast<double>(columns);
}

class Layers : public BakeTest, public testing::WithParamInterface<BakedBy> {
 protected:
  Layers() { baker_ = Baker(GetParam(), shaders_); }
  std::vector<Texel> baked_layers(const Cloudscape& sky) { return texels_of(bake(bake_recipe(sky)).shape); }
};
INSTANTIATE_TEST_SUITE_P(ByTheDeviceAndTheProcessor, Layers, testing::Values(BakedBy::device, BakedBy::processor),
                         [](const auto& by) { return by.param == BakedBy::device ? "device" : "processor"; });

// A column's greatest texel, which sets the threshold, differs by rounding, and all that lies above it does.
class LayersOfTheProcessor : public BakeTest {};
TEST_F(LayersOfTheProcessor, AreThoseOfTheDevice) {
  const auto baked_by = [&](BakedBy by) {
    baker_ = Baker(by, shaders_);
    return texels_of(bake(bake_recipe(three_layers())).shape);
  };
  const std::vector<Texel> device = baked_by(BakedBy::device), processor = baked_by(BakedBy::processor);
  ASSERT_EQ(device.size(), processor.size());
  for (std::size_t i = 0; i < device.size(); ++i) {
    ASSERT_NEAR(processor[i].shape, device[i].shape, 0.002) << i;
    ASSERT_NEAR(processor[i].density, device[i].density, 0.03) << i << ": it goes over within a twentieth of shape";
  }
}

constexpr double ties = 0.01;  // columns whose maxima are one of 16 bits with the threshold's

TEST_P(Layers, AreEachBetweenTheirAltitudesWithTheirCoverage) {
  const Cloudscape sky = three_layers();
  const std::vector<Texel> texels = baked_layers(sky);
  ASSERT_EQ(texels.size(), std::size_t{side} * side * side);
  EXPECT_NEAR(coverage_of(texels, 20, 24), 0.7, ties);
  EXPECT_EQ(coverage_of(texels, 12, 20), 0);
  EXPECT_EQ(coverage_of(texels, 24, side), 0);
  Cloudscape heaps = sky, shreds = sky;
  heaps.layers.clear();
  shreds.shape.coverage = 0;
  EXPECT_NEAR(coverage_of(baked_layers(heaps), 0, 12), 0.4, ties);
  EXPECT_EQ(coverage_of(baked_layers(heaps), 12, side), 0);
  EXPECT_NEAR(coverage_of(baked_layers(shreds), 2, 6), 0.2, ties);
  EXPECT_NEAR(coverage_of(baked_layers(shreds), 0, 12), 0.2, ties) << "and nowhere else";
}

// What is added takes nothing away, and the union is no more than both.
TEST_P(Layers, AreAUnion) {
  const Cloudscape sky = three_layers();
  Cloudscape heaps = sky, others = sky;
  heaps.layers.clear();
  others.shape.coverage = 0;
  const std::vector<Texel> all = baked_layers(sky), own = baked_layers(heaps), added = baked_layers(others);
  int both = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    ASSERT_EQ(all[i].cloud(), own[i].cloud() || added[i].cloud()) << i;
    both += own[i].cloud() && added[i].cloud() ? 1 : 0;
  }
  EXPECT_GT(both, 20) << "of what lies in one place";
}

// Of the layer that is there; in the clear air about it too, so that nothing changes in the outermost texel.
TEST_P(Layers, HaveTheirDensityInTheirCloudsAndAboutThem) {
  Cloudscape sky = three_layers();
  sky.layers.pop_back();
  const std::vector<Texel> texels = baked_layers(sky);
  constexpr std::size_t slice = std::size_t{side} * side;
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const auto z = static_cast<int>(i / slice);
    if (z > 13 && z < 18) continue;  // between them
    ASSERT_NEAR(texels[i].density, z <= 13 ? 1 : 0.25, 1e-3) << z;
  }
}

// Where layers overlap the density is between theirs, and goes from one to the other over what their shapes differ by.
TEST_P(Layers, BlendTheirDensitiesWhereTheyMeet) {
  const std::vector<Texel> texels = baked_layers(three_layers());
  int of_one = 0, of_other = 0;
  for (std::size_t i = 0; i < std::size_t{6} * side * side; ++i) {
    ASSERT_GE(texels[i].density, 0.499);
    ASSERT_LE(texels[i].density, 1);
    if (texels[i].cloud()) (texels[i].density < 0.51 ? of_other : of_one) += 1;
  }
  EXPECT_GT(of_one, 100);
  EXPECT_GT(of_other, 20);
}

TEST_P(Layers, AreTheSameAtEveryBakeAndFromTheCache) {
  const BakeRecipe recipe = bake_recipe(three_layers());
  const BakedTexels texels = bake(recipe);
  EXPECT_EQ(bake(recipe), texels);
  const CacheFolder folder;
  const BakeCache cache(folder.path(), 1ULL << 30);
  cache.store(texels);
  EXPECT_EQ(cache.load(recipe), texels);
  EXPECT_FALSE(cache.load(bake_recipe(Cloudscape{})));
}

// Frames go in between; each slab is a part of the work.
TEST_P(Layers, AreBakedInSlabs) {
  BakeRecipe recipe = bake_recipe(three_layers());
  recipe.resolution = 128;
  const std::unique_ptr<BakeJob> job = baker_.begin(recipe);
  double before = -1;
  int slabs = 0;
  do {
    EXPECT_GE(job->progress(), before);
    before = job->progress();
    ++slabs;
  } while (!job->advance());
  EXPECT_EQ(job->progress(), 1);
  EXPECT_GT(slabs, 20) << "128 slices of three layers, four at a time where there is noise";
}

TEST_P(Layers, TakeTheBytesThatWereForetold) {
  const Cloudscape sky = three_layers();
  const BakedCloudscape baked(bake(bake_recipe(sky)));
  EXPECT_EQ(baked.shape().format(), gpu::Format::rg16f);
  EXPECT_EQ(baked.bytes(), bake_bytes(sky));
}

// One texel's layer, or one that lies between the middles of two, is no reason to fail.
TEST_P(Layers, MayBeThinnerThanATexel) {
  Cloudscape sky = three_layers();
  sky.volume.resolution = 16;
  for (NoiseChannel& channel : sky.noise.channels) channel.frequency = 4, channel.octaves = 1;
  sky.layers[0].bottom_m = 3600, sky.layers[0].top_m = 3601;
  for (const Texel& texel : baked_layers(sky)) ASSERT_TRUE(std::isfinite(texel.shape) && std::isfinite(texel.density));
}

// The bounds that the march and the path tracer go by: no texel of cloud is outside them.
TEST_P(Layers, AreWithinTheirBounds) {
  const BakedTexels texels = bake(bake_recipe(three_layers()));
  const BakedCloudscape baked(texels);
  const std::vector<Texel> own = texels_of(texels.shape);
  const MajorantBuilder builder(shaders_);
  const Majorants majorants = builder.build(baked, {});
  const glm::ivec3 size = baked.structure_size();
  const std::vector<float> fine = gpu::as_numbers<float>(majorants.fine.download());
  int loose = 0;
  for (int i = 0; i < side * side * side; ++i) {
    const glm::dvec3 texel(i % side, i / side % side, i / (side * side));
    const glm::ivec3 cell((texel + 0.5) / double(side) * glm::dvec3(size));
    const auto at = 2 * static_cast<std::size_t>((cell.z * size.y + cell.y) * size.x + cell.x);
    ASSERT_GE(fine[at], own[static_cast<std::size_t>(i)].shape - 1e-6);
    ASSERT_GE(fine[at + 1], own[static_cast<std::size_t>(i)].density - 1e-6);
    loose += fine[at + 1] > 0.9 ? 1 : 0;
  }
  EXPECT_LT(loose, 0.7 * side * side * side) << "a bound of 1 everywhere makes thin clouds dear";
}

}  // namespace
}  // namespace cloudscape::bake
