// A recipe names all that a bake depends on and nothing else; and the permutations.
#include "bake/recipe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

#include "bake/permutation.h"

namespace cloudscape::bake {
namespace {

using Change = std::function<void(Cloudscape&)>;

std::string key_after(const Change& change) {
  Cloudscape cloudscape;
  cloudscape.shape.towers = {Tower{}};
  change(cloudscape);
  return bake_key(bake_recipe(cloudscape));
}

TEST(Recipe, ChangesItsKeyWithAllThatTheTexturesHold) {
  const std::vector<Change> changes{
      [](Cloudscape&) {},
      [](Cloudscape& c) { c.seed = 2; },
      [](Cloudscape& c) { c.volume.resolution = 64; },
      [](Cloudscape& c) { c.volume.size_m.z *= 2; },
      [](Cloudscape& c) { c.volume.kind = VolumeKind::sphere; },
      [](Cloudscape& c) { c.noise.channels[0].worley_mix = 0.5; },
      [](Cloudscape& c) { c.noise.channels[1].frequency = 8; },
      [](Cloudscape& c) { c.noise.channels[2].octaves = 1; },
      [](Cloudscape& c) { c.noise.channels[3].lacunarity = 4; },
      [](Cloudscape& c) { c.noise.channels[3].gain = 0.4; },
      [](Cloudscape& c) { c.shape.height_rise = 10; },
      [](Cloudscape& c) { c.shape.height_fall = 2; },
      [](Cloudscape& c) { c.shape.towers.clear(); },
      [](Cloudscape& c) { c.shape.towers[0].center.x = 0.4; },
      [](Cloudscape& c) { c.shape.towers[0].radius = 0.1; },
      [](Cloudscape& c) { c.shape.towers[0].top = 0.5; },
      [](Cloudscape& c) { c.shape.towers[0].strength = 1; },
      [](Cloudscape& c) { c.detail.resolution = 64; },
      [](Cloudscape& c) { c.detail.frequency = 8; },
      [](Cloudscape& c) { c.detail.octaves = 2; },
  };
  std::set<std::string> keys;
  for (const Change& change : changes) keys.insert(key_after(change));
  EXPECT_EQ(keys.size(), changes.size());
  for (const std::string& key : keys) EXPECT_EQ(key.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(keys.begin()->size(), 64U);
}

TEST(Recipe, KeepsItsKeyWhenOnlyTheMarchChanges) {
  const std::string key = key_after([](Cloudscape&) {});
  const std::vector<Change> changes{
      [](Cloudscape& c) { c.title = "another"; },
      [](Cloudscape& c) { c.medium.extinction_per_m = 0.1; },
      [](Cloudscape& c) { c.medium.phase.asymmetry_g = 0.5; },
      [](Cloudscape& c) { c.sun.elevation_deg = 3; },
      [](Cloudscape& c) { c.view.pose.azimuth_deg = 123; },
      [](Cloudscape& c) { c.shape.coverage = 0.9; },
      [](Cloudscape& c) { c.shape.edge_softness = 0.2; },
      [](Cloudscape& c) { c.shape.coverage_variation.amount = 0.5; },
      [](Cloudscape& c) { c.noise.channels[1].weight = 2; },
      [](Cloudscape& c) { c.detail.strength = 0.3; },
      [](Cloudscape& c) { c.detail.period_m = 300; },
      [](Cloudscape& c) { c.volume.origin_m.x = 500; },
      [](Cloudscape& c) { c.volume.size_m *= 2; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) EXPECT_EQ(key_after(changes[i]), key) << "change " << i;
}

// What is mixed when it is baked depends on the weights; but for the first channel's, which is the shape itself.
TEST(Recipe, OfAMixedShapeChangesItsKeyWithTheWeights) {
  const auto mixed = [](Cloudscape& c) { c.volume.format = VolumeFormat::r16f; };
  const std::string key = key_after(mixed);
  EXPECT_NE(key, key_after([](Cloudscape&) {}));
  for (std::size_t channel = 0; channel < 4; ++channel) {
    const std::string other = key_after([&](Cloudscape& c) {
      mixed(c);
      c.noise.channels[channel].weight = 2;
    });
    EXPECT_EQ(other == key, channel == 0) << channel;
  }
}

// As they were before there were layers: what lies in people's caches is still found.
TEST(Recipe, WithoutLayersHasTheKeyItAlwaysHad) {
  EXPECT_EQ(bake_key(bake_recipe(Cloudscape{})), "16028384f3e59adefae233a41e39435cf4acac251afb7b1345d3c6a616f2c70a");
}

// Of several layers all of it is baked in, each layer's threshold too.
TEST(Recipe, OfLayersChangesItsKeyWithAllThatTheyAre) {
  const auto key_with = [](const Change& change) {
    return key_after([&](Cloudscape& c) {
      c.layers = {Layer{}};
      change(c);
    });
  };
  const std::vector<Change> changes{
      [](Cloudscape&) {},
      [](Cloudscape& c) { c.seed = 2; },
      [](Cloudscape& c) { c.layers.push_back({}); },
      [](Cloudscape& c) { c.layers[0].bottom_m = 2000; },
      [](Cloudscape& c) { c.layers[0].top_m = 2000; },
      [](Cloudscape& c) { c.layers[0].noise.worley_mix = 0.1; },
      [](Cloudscape& c) { c.layers[0].noise.frequency = 8; },
      [](Cloudscape& c) { c.layers[0].noise.octaves = 1; },
      [](Cloudscape& c) { c.layers[0].noise.lacunarity = 4; },
      [](Cloudscape& c) { c.layers[0].noise.gain = 0.1; },
      [](Cloudscape& c) { c.layers[0].height_rise = 5; },
      [](Cloudscape& c) { c.layers[0].height_fall = 5; },
      [](Cloudscape& c) { c.layers[0].coverage = 0.1; },
      [](Cloudscape& c) { c.layers[0].density = 0.1; },
      [](Cloudscape& c) { c.shape.coverage = 0.1; },
      [](Cloudscape& c) { c.shape.threshold = 0.1; },
      [](Cloudscape& c) { c.shape.bottom_m = 2000; },
      [](Cloudscape& c) { c.shape.top_m = 2000; },
      [](Cloudscape& c) { c.shape.density = 0.1; },
      [](Cloudscape& c) { c.shape.height_rise = 10; },
      [](Cloudscape& c) { c.shape.towers.clear(); },
      [](Cloudscape& c) { c.noise.channels[0].worley_mix = 0.5; },
      [](Cloudscape& c) { c.noise.channels[1].weight = 2; },
  };
  std::set<std::string> keys{key_after([](Cloudscape&) {})};
  for (const Change& change : changes) keys.insert(key_with(change));
  EXPECT_EQ(keys.size(), changes.size() + 1);
  const std::string key = key_with([](Cloudscape&) {});
  EXPECT_EQ(key, key_with([](Cloudscape& c) { c.medium.extinction_per_m = 0.1; }));
  EXPECT_EQ(key, key_with([](Cloudscape& c) { c.shape.coverage_variation.amount = 0.5; }));
  EXPECT_EQ(key, key_with([](Cloudscape& c) { c.volume.format = VolumeFormat::r16f; })) << "they have one of their own";
}

// A layer of its own, of less than all of the volume or of less density, is of the same kind as several.
TEST(Recipe, OfAnOwnLayerThatIsNotAllOfTheVolumeIsLayered) {
  Cloudscape sky;
  EXPECT_TRUE(bake_recipe(sky).layers.empty());
  sky.shape.top_m = 2000;
  EXPECT_EQ(bake_recipe(sky).layers.size(), 1U);
  EXPECT_EQ(bake_recipe(sky).layers[0].top, 0.5);
  sky.volume.kind = VolumeKind::sphere;
  EXPECT_TRUE(bake_recipe(sky).layers.empty());
}

TEST(Recipe, ChangesItsKeyWithTheVersionOfTheShaders) {
  BakeRecipe recipe;
  const std::string key = bake_key(recipe);
  ++recipe.version;
  EXPECT_NE(bake_key(recipe), key);
}

TEST(Recipe, OfAHomogeneousVolumeIsOneTexel) {
  std::set<std::string> keys;
  for (const VolumeKind kind : {VolumeKind::sphere, VolumeKind::box, VolumeKind::slab, VolumeKind::gaussian}) {
    Cloudscape cloudscape;
    cloudscape.volume.kind = kind;
    cloudscape.seed = static_cast<std::uint32_t>(kind);
    const BakeRecipe recipe = bake_recipe(cloudscape);
    EXPECT_EQ(recipe.resolution, 1);
    EXPECT_EQ(recipe.detail_resolution, 1);
    keys.insert(bake_key(recipe));
  }
  EXPECT_EQ(keys.size(), 1U);
}

TEST(Permutation, OfSeedZeroIsPerlins) {
  const auto table = permutation_table(0);
  const std::array<int, 8> first{151, 160, 137, 91, 90, 15, 131, 13}, last{128, 195, 78, 66, 215, 61, 156, 180};
  EXPECT_TRUE(std::equal(first.begin(), first.end(), table.begin()));
  EXPECT_TRUE(std::equal(last.begin(), last.end(), table.begin() + 248));
}

TEST(Permutation, HoldsEveryNumberOnceAndDependsOnTheSeedAlone) {
  std::set<std::array<std::uint8_t, 256>> tables;
  for (const std::uint32_t seed : {0U, 1U, 2U, 77U, 4294967295U}) {
    auto table = permutation_table(seed);
    EXPECT_EQ(table, permutation_table(seed));
    tables.insert(table);
    std::sort(table.begin(), table.end());
    for (std::size_t i = 0; i < 256; ++i) ASSERT_EQ(table[i], i);
  }
  EXPECT_EQ(tables.size(), 5U);
}

}  // namespace
}  // namespace cloudscape::bake
