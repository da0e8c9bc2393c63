// That a difference is seen, and its size.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "golden.h"

namespace cloudscape::golden {
namespace {

Picture grey(std::uint8_t value) { return {{4, 2}, std::vector<std::uint8_t>(4 * 2 * 3, value)}; }

struct File {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("cloudscape-golden-" + std::to_string(getpid())) / "picture.png";
  ~File() { std::filesystem::remove_all(path.parent_path()); }
};

TEST(Compare, FindsTheLargestAndTheMean) {
  Picture other = grey(100);
  EXPECT_EQ(compare(other, grey(100)).largest, 0);
  other.rgb[5] = 88;
  EXPECT_EQ(compare(other, grey(100)).largest, 12);
  EXPECT_DOUBLE_EQ(compare(other, grey(100)).mean, 12.0 / 24);
  EXPECT_DOUBLE_EQ(compare(grey(100), other).mean, 12.0 / 24);
}

TEST(Compare, ShowsWhereItIs) {
  Picture other = grey(100);
  other.rgb[5] = 88, other.rgb[6] = 200;
  const Picture shown = difference_picture(other, grey(100));
  EXPECT_EQ(shown.rgb[4], 0);
  EXPECT_EQ(shown.rgb[5], 96);
  EXPECT_EQ(shown.rgb[6], 255);
}

TEST(Png, ComesBackAsItWas) {
  const File file;
  Picture picture = grey(7);
  picture.rgb[3] = 255;
  write_png(file.path, picture);
  const auto back = read_png(file.path);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->size_px, picture.size_px);
  EXPECT_EQ(back->rgb, picture.rgb);
}

TEST(Png, IsNotReadFromAnythingElse) {
  const File file;
  EXPECT_FALSE(read_png(file.path));
  write_png(file.path, grey(7));
  std::ofstream(file.path) << "no picture";
  EXPECT_FALSE(read_png(file.path));
}

}  // namespace
}  // namespace cloudscape::golden
