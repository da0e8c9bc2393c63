// Which files count as whole pictures: those that the encoders make, and none that is cut off or another size.
#include "encode/whole_image.h"

#include <unistd.h>

#include <fstream>

#include "frames.h"

#include <gtest/gtest.h>

namespace cloudscape::encode {
namespace {

class WholeImage : public testing::TestWithParam<ImageFormat> {
 protected:
  void write(const EncodedFrame& image, std::size_t bytes_less = 0) const {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(image.bytes.data()),
               static_cast<std::streamsize>(image.bytes.size() - bytes_less));
  }
  static EncodedFrame picture(ImageSize size_px) {
    const bool exr = GetParam() == ImageFormat::exr;
    return encode(exr ? radiance_frame(size_px) : display_frame(size_px), encoding_of(GetParam()));
  }
  bool whole(ImageSize size_px = size) const { return is_whole_image(path_, GetParam(), size_px); }
  void TearDown() override { std::filesystem::remove(path_); }
  static constexpr ImageSize size{50, 40};
  const std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("cloudscape-whole-" + std::to_string(::getpid()));
};

TEST_P(WholeImage, WhatWasEncodedIsWhole) {
  write(picture(size));
  EXPECT_TRUE(whole());
  EXPECT_FALSE(whole({40, 50}));
  EXPECT_FALSE(whole({50, 41}));
}

TEST_P(WholeImage, WhatIsCutOffIsNot) {
  const EncodedFrame image = picture(size);
  for (const std::size_t less :
       {std::size_t{1}, std::size_t{20}, image.bytes.size() / 2, image.bytes.size() - 10, image.bytes.size()}) {
    write(image, less);
    EXPECT_FALSE(whole()) << less << " bytes are missing of " << image.bytes.size();
  }
}

TEST_P(WholeImage, OtherFormatsAndOtherThingsAreNot) {
  EXPECT_FALSE(whole()) << "no file";
  EXPECT_FALSE(is_whole_image(std::filesystem::temp_directory_path(), GetParam(), size));
  write(picture(size));
  for (const auto format : {ImageFormat::jpeg, ImageFormat::png, ImageFormat::exr})
    EXPECT_EQ(is_whole_image(path_, format, size), format == GetParam());
  std::ofstream(path_, std::ios::binary) << std::string(1000, '\xff');
  EXPECT_FALSE(whole());
}

INSTANTIATE_TEST_SUITE_P(Formats, WholeImage, testing::Values(ImageFormat::jpeg, ImageFormat::png, ImageFormat::exr));

}  // namespace
}  // namespace cloudscape::encode
