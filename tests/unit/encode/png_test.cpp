// What libpng reads back from our PNGs.
#include <gtest/gtest.h>
#include <png.h>

#include <map>

#include "core/version.h"
#include "frames.h"

namespace cloudscape {
namespace {

struct Decoded {
  int width = 0, height = 0, depth = 0, colour_type = 0;
  bool srgb = false;
  std::map<std::string, std::string> texts;
  std::vector<std::uint8_t> rgb;
};

struct Source {
  const std::vector<std::uint8_t>& bytes;
  std::size_t position;
};

void read(png_structp png, png_bytep out, std::size_t size) {
  auto* source = static_cast<Source*>(png_get_io_ptr(png));
  if (source->position + size > source->bytes.size()) png_error(png, "the file ends early");
  std::copy_n(source->bytes.begin() + static_cast<std::ptrdiff_t>(source->position), size, out);
  source->position += size;
}

// A broken file ends the program with libpng's message, which fails the test.
Decoded decode(const EncodedFrame& encoded) {
  Source source{encoded.bytes, encoded.front};
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_read_fn(png, &source, read);
  png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);

  Decoded decoded;
  decoded.width = static_cast<int>(png_get_image_width(png, info));
  decoded.height = static_cast<int>(png_get_image_height(png, info));
  decoded.depth = png_get_bit_depth(png, info);
  decoded.colour_type = png_get_color_type(png, info);
  int intent = -1, count = 0;
  decoded.srgb = png_get_sRGB(png, info, &intent) != 0;
  png_textp texts = nullptr;
  png_get_text(png, info, &texts, &count);
  for (int i = 0; i < count; ++i) decoded.texts[texts[i].key] = texts[i].text;
  for (int y = 0; y < decoded.height; ++y) {
    const png_bytep row = png_get_rows(png, info)[y];
    decoded.rgb.insert(decoded.rgb.end(), row, row + png_get_rowbytes(png, info));
  }
  png_destroy_read_struct(&png, &info, nullptr);
  EXPECT_EQ(source.position, encoded.bytes.size()) << "nothing may follow the picture";
  return decoded;
}

TEST(Png, ReadsBackExactlyInEverySize) {
  for (const ImageSize size_px : {ImageSize{160, 90}, ImageSize{1, 1}, ImageSize{3, 5}}) {
    const Frame frame = display_frame(size_px);
    const Decoded decoded = decode(encode::encode(frame, encoding_of(ImageFormat::png)));
    ASSERT_EQ(decoded.width, size_px.width);
    ASSERT_EQ(decoded.height, size_px.height);
    EXPECT_EQ(decoded.depth, 8);
    ASSERT_EQ(decoded.colour_type, PNG_COLOR_TYPE_RGB);
    for (std::size_t i = 0; i < decoded.rgb.size(); ++i)
      ASSERT_EQ(decoded.rgb[i], frame.display_rgba[i / 3 * 4 + i % 3]) << "value " << i;
  }
}

TEST(Png, SaysItsColourSpaceAndItsMaker) {
  const Decoded decoded = decode(encode::encode(display_frame({8, 8}), encoding_of(ImageFormat::png)));
  EXPECT_TRUE(decoded.srgb);
  EXPECT_EQ(decoded.texts.at("Software"), std::string("cloudscape ") + version);
}

}  // namespace
}  // namespace cloudscape
