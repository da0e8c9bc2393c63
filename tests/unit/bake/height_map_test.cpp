// Height maps from files: each format to the last digit, and one sentence for each that cannot be used.
#include "bake/height_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/error.h"
#include "tests/height_maps.h"

namespace cloudscape::bake {
namespace {

using testing::HasSubstr;

class HeightMaps : public testing::Test {
 protected:
  HeightMap read(const std::string& name) const { return read_height_map(folder.path(), name); }
  std::string refusal(const std::string& name) const {
    try {
      read(name);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  }
  // One sentence that names the file, what is wrong, and what to do.
  void expect_refused(const std::string& name, const std::string& wrong, const std::string& remedy) const {
    const std::string said = refusal(name);
    EXPECT_THAT(said, HasSubstr("'" + name + "'"));
    EXPECT_THAT(said, HasSubstr(wrong)) << name;
    EXPECT_THAT(said, HasSubstr(remedy)) << name;
    EXPECT_EQ(said.find('\n'), std::string::npos);
    EXPECT_EQ(said.find(folder.path().string()), std::string::npos) << "a client need not know where the folder is";
  }
  HeightMapFolder folder;
};

TEST_F(HeightMaps, OfEightBitsAreReadExactly) {
  folder.write_png<std::uint8_t>("a.png", 3, 2, {0, 51, 255, 1, 2, 3}, PNG_FORMAT_GRAY);
  const HeightMap map = read("a.png");
  EXPECT_EQ(map.width, 3);
  EXPECT_EQ(map.height, 2);
  EXPECT_EQ(map.values, (std::vector<float>{0, 0.2F, 1, 1 / 255.0F, 2 / 255.0F, 3 / 255.0F}));
}

TEST_F(HeightMaps, OfSixteenBitsAreReadExactly) {
  folder.write_png<std::uint16_t>("a.png", 2, 2, {0, 1, 256, 65535}, PNG_FORMAT_LINEAR_Y);
  EXPECT_EQ(read("a.png").values, (std::vector<float>{0, 1 / 65535.0F, 256 / 65535.0F, 1}));
}

TEST_F(HeightMaps, OfFloatsAreReadAsTheyAre) {
  folder.write_exr("a.exr", 2, 3, {-12.5F, 0, 4808.75F, 1, 2, 3}, {"height"});
  const HeightMap map = read("a.exr");
  EXPECT_EQ(map.width, 2);
  EXPECT_EQ(map.values, (std::vector<float>{-12.5F, 0, 4808.75F, 1, 2, 3}));
}

TEST_F(HeightMaps, ThatAreNotThereAreRefused) {
  expect_refused("none.png", "is not in the folder", "put it there");
  std::filesystem::create_directory(folder.path() / "folder.png");
  expect_refused("folder.png", "is not in the folder", "put it there");
  EXPECT_THROW(read_height_map({}, "a.png"), Error) << "without a folder there is none";
}

TEST_F(HeightMaps, OutsideTheFolderAreRefused) {
  folder.write_png<std::uint8_t>("a.png", 1, 1, {7}, PNG_FORMAT_GRAY);
  const std::string up = "../" + folder.path().filename().string() + "/a.png";
  ASSERT_TRUE(std::filesystem::exists(folder.path() / up));
  for (const std::string& name : {up, (folder.path() / "a.png").string(), std::string("./a.png"), std::string(".png"),
                                  std::string("a.jpg"), std::string("..\\a.png"), std::string()})
    EXPECT_THAT(refusal(name), HasSubstr("bare name")) << name;
}

TEST_F(HeightMaps, ThatAreDamagedAreRefused) {
  folder.write("text.png", "this is text and no picture");
  expect_refused("text.png", "is damaged or no PNG", "write it anew");
  folder.write("text.exr", "this is text and no picture");
  expect_refused("text.exr", "is damaged or no EXR", "write it anew");
  folder.write_png<std::uint8_t>("whole.png", 64, 64, std::vector<std::uint8_t>(64 * 64, 7), PNG_FORMAT_GRAY);
  folder.write("half.png", folder.read("whole.png").substr(0, folder.read("whole.png").size() / 2));
  expect_refused("half.png", "is damaged", "write it anew");
  folder.write_exr("whole.exr", 64, 64, std::vector<float>(64 * 64, 7));
  folder.write("half.exr", folder.read("whole.exr").substr(0, folder.read("whole.exr").size() / 2));
  expect_refused("half.exr", "is damaged", "write it anew");
}

TEST_F(HeightMaps, OfAnotherKindAreRefused) {
  folder.write_png<std::uint8_t>("colour.png", 1, 1, {1, 2, 3}, PNG_FORMAT_RGB);
  expect_refused("colour.png", "no grey picture", "convert it");
  folder.write_exr("colour.exr", 1, 1, {1}, {"R", "G", "B"});
  expect_refused("colour.exr", "3 channels", "write it with one");
  folder.write_exr("gap.exr", 2, 1, {1, std::numeric_limits<float>::quiet_NaN()});
  expect_refused("gap.exr", "not finite", "repair it");
}

TEST_F(HeightMaps, ThatAreTooLargeAreRefusedBeforeTheyAreRead) {
  folder.write_png<std::uint8_t>("wide.png", 8193, 1, std::vector<std::uint8_t>(8193), PNG_FORMAT_GRAY);
  expect_refused("wide.png", "8193x1", "at most 8192");
  folder.write_exr("wide.exr", 8193, 1, std::vector<float>(8193));
  expect_refused("wide.exr", "8193x1", "at most 8192");
}

TEST(Resampling, TurnsTheMapSouthUpAndKeepsItsValues) {
  const HeightMap map{2, 2, {1, 2, 3, 4}};  // 1 2 in the north
  EXPECT_EQ(resampled(map, 2), (std::vector<float>{3, 4, 1, 2}));
}

TEST(Resampling, KeepsLevelLandAndTheMean) {
  for (const float value : resampled({3, 5, std::vector<float>(15, 0.25F)}, 4)) EXPECT_FLOAT_EQ(value, 0.25F);
  HeightMap spike{64, 64, std::vector<float>(64 * 64, 0)};
  spike.values[64 * 30 + 33] = 16;
  double sum = 0;
  for (const float value : resampled(spike, 16)) sum += value;
  EXPECT_NEAR(sum, 1, 1e-3) << "a point of the coarse lattice stands for 16 pixels";
}

}  // namespace
}  // namespace cloudscape::bake
