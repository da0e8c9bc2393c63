#include "golden.h"

#include <png.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "encode/encode.h"

namespace cloudscape::golden {

Picture picture_of(const Frame& frame) {
  Picture picture{frame.request.size_px, {}};
  for (std::size_t i = 0; i < frame.display_rgba.size(); ++i)
    if (i % 4 != 3) picture.rgb.push_back(frame.display_rgba[i]);
  return picture;
}

std::optional<Picture> read_png(const std::filesystem::path& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) return std::nullopt;
  image.format = PNG_FORMAT_RGB;
  Picture picture{{static_cast<int>(image.width), static_cast<int>(image.height)}, {}};
  picture.rgb.resize(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, picture.rgb.data(), 0, nullptr) == 0) return std::nullopt;
  return picture;
}

void write_png(const std::filesystem::path& path, const Picture& picture) {
  Frame frame;
  frame.request.size_px = picture.size_px;
  frame.request.cloudscape = std::make_shared<const Cloudscape>();
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3)
    frame.display_rgba.insert(frame.display_rgba.end(), {picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2], 255});
  const EncodedFrame encoded = encode::encode(frame, {ImageFormat::png});
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(encoded.bytes.data()), static_cast<std::streamsize>(encoded.bytes.size()));
}

Difference compare(const Picture& actual, const Picture& expected) {
  Difference difference;
  for (std::size_t i = 0; i < actual.rgb.size(); ++i) {
    const int step = std::abs(actual.rgb[i] - expected.rgb[i]);
    difference.largest = std::max(difference.largest, step);
    difference.mean += step;
  }
  difference.mean /= static_cast<double>(std::max<std::size_t>(1, actual.rgb.size()));
  return difference;
}

Picture difference_picture(const Picture& actual, const Picture& expected) {
  Picture picture = actual;
  for (std::size_t i = 0; i < actual.rgb.size(); ++i)
    picture.rgb[i] = static_cast<std::uint8_t>(std::min(255, 8 * std::abs(actual.rgb[i] - expected.rgb[i])));
  return picture;
}

}  // namespace cloudscape::golden
