// Pictures against expected ones: reading, comparing, and what a failure leaves behind.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/frame.h"

namespace cloudscape::golden {

struct Picture {
  ImageSize size_px;
  std::vector<std::uint8_t> rgb;
};

struct Difference {
  int largest = 0;  // of one channel of one pixel, in steps of 8 bits
  double mean = 0;  // of all
};

Picture picture_of(const Frame& frame);
std::optional<Picture> read_png(const std::filesystem::path& path);  // nullopt: there is none, or it is no PNG
void write_png(const std::filesystem::path& path, const Picture& picture);
Difference compare(const Picture& actual, const Picture& expected);  // of equal sizes
// Each channel's difference, eight times as strong.
Picture difference_picture(const Picture& actual, const Picture& expected);

}  // namespace cloudscape::golden
