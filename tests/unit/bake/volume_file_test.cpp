// Volumes as raw floats and as slice atlases: each voxel in its place, and one sentence for each file that is none.
#include "bake/volume_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/gtc/packing.hpp>
#include <limits>

#include "core/error.h"
#include "tests/height_maps.h"

namespace cloudscape::bake {
namespace {

using testing::HasSubstr;

std::string bytes_of(const std::vector<float>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

std::vector<float> counted(std::size_t count) {
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<float>(i);
  return values;
}

class VolumeFiles : public testing::Test {
 protected:
  static GridRecipe recipe(const std::string& file, const std::array<int, 3>& size) {
    GridRecipe recipe;
    recipe.file = file, recipe.size = size, recipe.vdb = file.ends_with(".vdb");
    return recipe;
  }
  Voxels read(const std::string& file, const std::array<int, 3>& size) const {
    return read_volume_file(folder.path(), recipe(file, size));
  }
  void expect_refused(const std::string& file, const std::array<int, 3>& size, const std::string& wrong) const {
    try {
      read(file, size);
      FAIL() << file << " was read";
    } catch (const UnusableFile& error) {
      const std::string said = error.what();
      EXPECT_THAT(said, HasSubstr("the volume '" + file + "' "));
      EXPECT_THAT(said, HasSubstr(wrong));
      EXPECT_EQ(said.find('\n'), std::string::npos);
      EXPECT_EQ(said.find(folder.path().string()), std::string::npos) << "a client need not know where the folder is";
    }
  }
  HeightMapFolder folder;
};

TEST_F(VolumeFiles, OfRawFloatsAreReadAsTheyAre) {
  folder.write("a.raw", bytes_of(counted(24)));
  const Voxels voxels = read("a.raw", {2, 3, 4});
  EXPECT_EQ(voxels.size, glm::ivec3(2, 3, 4));
  EXPECT_EQ(voxels.densities, counted(24));
}

TEST_F(VolumeFiles, OfAnotherSizeAreRefusedBeforeTheyAreRead) {
  folder.write("a.raw", bytes_of(counted(24)));
  expect_refused("a.raw", {2, 3, 5}, "has 96 bytes, and 2x3x5 voxels of 32 bits have 120");
  expect_refused("a.raw", {512, 512, 512}, "have 536870912");
  folder.write("cut.raw", bytes_of(counted(24)).substr(0, 95));
  expect_refused("cut.raw", {2, 3, 4}, "has 95 bytes");
  folder.write("none.raw", "");
  expect_refused("none.raw", {1, 1, 1}, "has 0 bytes");
}

// Five slices of 3 x 2 in three columns and two rows, north up.
TEST_F(VolumeFiles, OfSlicesAreReadFromTheirPlaces) {
  std::vector<float> pixels(9 * 4, 0.0F);
  for (int z = 0; z < 5; ++z)
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 3; ++x)
        pixels[static_cast<std::size_t>((z / 3 * 2 + 1 - y) * 9 + z % 3 * 3 + x)] =
            static_cast<float>((z * 2 + y) * 3 + x);
  folder.write_exr("a.exr", 9, 4, pixels);
  EXPECT_EQ(read("a.exr", {3, 2, 5}).densities, counted(30));
  folder.write_exr("r.exr", 9, 4, pixels, {"A", "B", "G", "R"});
  EXPECT_EQ(read("r.exr", {3, 2, 5}).densities, counted(30));
  expect_refused("a.exr", {3, 2, 4}, "has 9x4 pixels, and 4 slices of 3x2 voxels in 2 columns have 6x4");
  folder.write_exr("z.exr", 9, 4, pixels, {"Z"});
  expect_refused("z.exr", {3, 2, 5}, "no channel Y");
  folder.write("half.exr", folder.read("a.exr").substr(0, folder.read("a.exr").size() / 2));
  expect_refused("half.exr", {3, 2, 5}, "is damaged");
}

TEST_F(VolumeFiles, OfImpossibleDensitiesAreRefused) {
  folder.write("a.raw", bytes_of({1, -0.5F}));
  expect_refused("a.raw", {2, 1, 1}, "negative densities");
  folder.write("b.raw", bytes_of({1, std::numeric_limits<float>::quiet_NaN()}));
  expect_refused("b.raw", {2, 1, 1}, "not finite");
  folder.write("c.raw", bytes_of({std::numeric_limits<float>::infinity(), 1}));
  expect_refused("c.raw", {2, 1, 1}, "not finite");
  folder.write("d.raw", bytes_of({0, 0}));
  expect_refused("d.raw", {2, 1, 1}, "is empty");
}

TEST_F(VolumeFiles, ThatAreNotThereOrElsewhereAreRefused) {
  expect_refused("none.raw", {1, 1, 1}, "is not in the folder of volumes");
  std::filesystem::create_directory(folder.path() / "folder.raw");
  expect_refused("folder.raw", {1, 1, 1}, "is not in the folder of volumes");
  folder.write("a.raw", bytes_of({1}));
  for (const std::string& name : {"../" + folder.path().filename().string() + "/a.raw",
                                  (folder.path() / "a.raw").string(), std::string("./a.raw"), std::string(".raw")})
    EXPECT_THROW(read(name, {1, 1, 1}), UnusableFile) << name;
  EXPECT_THROW(read_volume_file({}, recipe("a.raw", {1, 1, 1})), UnusableFile) << "without a folder there is none";
  folder.write("a.vdb", "no volume");
  expect_refused("a.vdb", {}, "");
}

TEST_F(VolumeFiles, BecomeSharesOfTheirGreatestDensity) {
  BakeRecipe asked;
  asked.format = ShapeFormat::r16f;
  const BakedTexels texels = grid_texels(asked, {{2, 1, 2}, {0, 5, 20, 10}, {1, 2, 3}, {4, 5, 6}});
  ASSERT_TRUE(texels.grid);
  EXPECT_EQ(texels.grid->greatest_density, 20);
  EXPECT_EQ(texels.grid->size, glm::ivec3(2, 1, 2));
  EXPECT_EQ(texels.grid->slice_maxima, (std::vector<float>{0.25F, 1}));
  EXPECT_EQ(texels.grid->low, glm::dvec3(1, 2, 3));
  std::vector<float> shares;
  for (std::size_t i = 0; i < 4; ++i)
    shares.push_back(
        glm::unpackHalf1x16(static_cast<std::uint16_t>(texels.shape[2 * i] | texels.shape[2 * i + 1] << 8)));
  EXPECT_EQ(shares, (std::vector<float>{0, 0.25F, 1, 0.5F}));
}

TEST_F(VolumeFiles, AreOtherRecipesWhenTheyChange) {
  Volume volume;
  volume.kind = VolumeKind::grid;
  volume.grid.file = "a.raw";
  folder.write("a.raw", "1234");
  const GridRecipe before = grid_recipe(volume, folder.path());
  EXPECT_EQ(grid_recipe(volume, folder.path()), before);
  folder.write("a.raw", "1235");
  EXPECT_NE(grid_recipe(volume, folder.path()), before);
}

}  // namespace
}  // namespace cloudscape::bake
