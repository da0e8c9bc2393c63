// Light that comes from the disk is the light that was stored, or none.
#include "bake/light_cache.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/height_maps.h"

namespace cloudscape::bake {
namespace {

// Two points, one of them at night.
std::vector<InScatterSolution> levels() {
  const auto grey = [](float v) { return Colours{v, v, v, 0}; };
  InScatterSolution level;
  level.light = {{Colours{0.31F, 0.52F, 0.7F, 0}, grey(0.1F), grey(0), grey(0.2F)},
                 {Colours{3e-7F, 2e-7F, 1e-7F, 0}, grey(0), grey(-1e-7F), grey(0)}};
  level.beam = {0.25F, 1};
  return {level, level};
}

class LightCacheTest : public testing::Test {
 protected:
  HeightMapFolder folder;
  KeptFiles files{folder.path(), 1 << 20};
  LightCache cache{files};
};

TEST_F(LightCacheTest, GivesBackWhatWasStored) {
  const LightTexels light = light_texels(levels());
  ASSERT_EQ(light.mean.size(), 4u);
  EXPECT_NEAR(light.mean[0].y, 0.52, 5e-4);
  EXPECT_NEAR(light.directed[0].x, 0.1 / (0.2126 * 0.31 + 0.7152 * 0.52 + 0.0722 * 0.7), 1e-3);
  cache.store("ab", light);
  EXPECT_EQ(cache.load("ab", 4), light) << "to the last bit: a picture must not depend on where its light came from";
  EXPECT_FALSE(cache.load("cd", 4));
}

TEST_F(LightCacheTest, IsNotTakenWhereTheGridHasAnotherSize) {
  cache.store("ab", light_texels(levels()));
  EXPECT_FALSE(cache.load("ab", 6));
}

TEST_F(LightCacheTest, DamagedFilesAreRemoved) {
  cache.store("ab", light_texels(levels()));
  std::ofstream(files.path_of("ab.light"), std::ios::app) << "more";
  EXPECT_FALSE(cache.load("ab", 4));
  EXPECT_FALSE(std::filesystem::exists(files.path_of("ab.light")));
}

}  // namespace
}  // namespace cloudscape::bake
