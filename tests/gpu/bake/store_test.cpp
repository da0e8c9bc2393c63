// Baked cloudscapes in memory, from the disk, or in the making.
#include "bake/store.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "fixture.h"

namespace cloudscape::bake {
namespace {

constexpr std::uint64_t plenty = 1ULL << 30;

class Store : public BakeTest {
 protected:
  BakeStore make(std::uint64_t limit_bytes = plenty) {
    return {context(), shaders_, BakeCache(folder_.path(), plenty), limit_bytes,
            [this](const BakeRecipe& recipe, double share) { progress_.emplace_back(recipe.seed, share); }};
  }
  CacheFolder folder_;
  std::vector<std::pair<std::uint32_t, double>> progress_;
};

// Several slabs, each of them quick.
BakeRecipe slow_recipe(std::uint32_t seed) {
  BakeRecipe recipe = tiny_recipe(seed);
  recipe.resolution = 64;
  for (NoiseChannel& channel : recipe.noise.channels) channel.worley_mix = 0;
  return recipe;
}

TEST_F(Store, KeepsWhatItBaked) {
  BakeStore store = make();
  const auto first = store.get(small_recipe());
  EXPECT_EQ(store.get(small_recipe()), first);
  EXPECT_EQ(store.find(small_recipe()), first);
  EXPECT_EQ(store.bytes(), first->bytes());
  EXPECT_EQ(first->bytes(), 2 * 16 * 16 * 16 * 4U + 128 * 128 * 16U);
  EXPECT_EQ(store.texels(small_recipe()), bake(small_recipe()));
}

TEST_F(Store, FindsNothingWhileTheBakeIsInTheMaking) {
  BakeStore store = make();
  EXPECT_EQ(store.find(slow_recipe(1)), nullptr);
  int steps = 0;
  while (!store.find(slow_recipe(1))) {
    store.advance(slow_recipe(1));
    ASSERT_LT(++steps, 100);
  }
  EXPECT_GT(steps, 1);
  ASSERT_EQ(progress_.size(), static_cast<std::size_t>(steps));
  EXPECT_TRUE(std::is_sorted(progress_.begin(), progress_.end()));
  for (int i = 0; i < steps; ++i) EXPECT_EQ(progress_[static_cast<std::size_t>(i)].second == 1, i == steps - 1);
}

TEST_F(Store, TakesFromTheDiskWhatAnotherBaked) {
  const BakedTexels texels = make().texels(small_recipe());
  progress_.clear();
  BakeStore another = make();
  const auto baked = another.find(small_recipe());
  ASSERT_TRUE(baked);
  EXPECT_THAT(progress_, testing::IsEmpty());
  EXPECT_EQ(baked->shape().download(), texels.shape);
  EXPECT_EQ(baked->detail().download(), texels.detail);
  EXPECT_EQ(baked->texels().variation, texels.variation);
}

TEST_F(Store, BakesAnewWhatIsDamagedOnDisk) {
  const BakedTexels texels = make().texels(small_recipe());
  const std::string file = (folder_.path() / (bake_key(small_recipe()) + ".bake")).string();
  std::fstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(5000) << "damage";
  progress_.clear();
  EXPECT_EQ(make().get(small_recipe())->shape().download(), texels.shape);
  EXPECT_EQ(progress_.back(), std::pair(small_recipe().seed, 1.0));
  EXPECT_EQ(BakeCache(folder_.path(), plenty).load(small_recipe()), texels);
}

// One tiny bake takes 262152 bytes, nearly all of it the variation map.
TEST_F(Store, DropsTheLeastRecentlyUsedBeyondItsLimit) {
  BakeStore store = make(600000);
  const std::weak_ptr<const BakedCloudscape> first = store.get(tiny_recipe(1)), second = store.get(tiny_recipe(2));
  EXPECT_FALSE(first.expired());
  store.find(tiny_recipe(1));
  store.get(tiny_recipe(3));
  EXPECT_FALSE(first.expired());
  EXPECT_TRUE(second.expired());
  EXPECT_LE(store.bytes(), 600000U);
}

TEST_F(Store, KeepsTheNewestEvenIfItIsTooLarge) {
  BakeStore store = make(1);
  const auto baked = store.get(tiny_recipe(1));
  EXPECT_EQ(store.find(tiny_recipe(1)), baked);
  store.get(tiny_recipe(2));
  EXPECT_EQ(store.bytes(), baked->bytes());
  EXPECT_EQ(baked->shape().download().size(), 4U);  // still whole for whoever holds it
}

// More than are baked at a time: some wait, none begins anew, and all come to an end.
TEST_F(Store, FinishesManyBakesInTurn) {
  BakeStore store = make();
  constexpr std::uint32_t count = 6;
  std::vector<std::shared_ptr<const BakedCloudscape>> baked(count);
  for (int round = 0; round < 60; ++round)
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!baked[i]) baked[i] = store.find(slow_recipe(i));
      if (!baked[i]) store.advance(slow_recipe(i));
    }
  for (const auto& one : baked) EXPECT_TRUE(one);
  EXPECT_EQ(std::ranges::count_if(progress_, [](const auto& step) { return step.second == 0.25; }), count);
}

// Four are baked at a time. Each has four slabs, so that its progress tells whether it began anew.
TEST_F(Store, GivesUpTheBakeThatWasAdvancedTheLongestAgo) {
  BakeStore store = make();
  using Step = std::pair<std::uint32_t, double>;
  const auto advanced = [&](std::uint32_t seed) {
    store.advance(slow_recipe(seed));
    return progress_.back();
  };
  for (const std::uint32_t seed : {1U, 2U, 3U, 4U}) EXPECT_EQ(advanced(seed), Step(seed, 0.25));
  for (const std::uint32_t seed : {3U, 1U, 4U}) EXPECT_EQ(advanced(seed), Step(seed, 0.5));
  EXPECT_EQ(advanced(5), Step(4, 0.5)) << "it waits";
  int calls = 0;
  while (advanced(5) != Step(5, 0.25)) ASSERT_LT(++calls, 100);
  for (const std::uint32_t seed : {3U, 1U, 4U}) EXPECT_EQ(advanced(seed), Step(seed, 0.75));
  for (const std::uint32_t seed : {3U, 1U, 4U, 5U}) store.get(slow_recipe(seed));
  EXPECT_EQ(advanced(2), Step(2, 0.25)) << "the one that was given up";
}

}  // namespace
}  // namespace cloudscape::bake
