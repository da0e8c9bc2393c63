// The three encoders behind `encode`: each returns `front` zero bytes and then the image. The frame has been checked.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/frame.h"

namespace cloudscape::encode {

using Bytes = std::vector<std::uint8_t>;

Bytes encode_jpeg(const Frame& frame, const Encoding& encoding, std::size_t front);
Bytes encode_png(const Frame& frame, std::size_t front);
Bytes encode_exr(const Frame& frame, const Encoding& encoding, std::size_t front);

std::string software();  // "cloudscape 0.1.0", what PNG and EXR files say they were written by

}  // namespace cloudscape::encode
