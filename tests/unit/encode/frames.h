// Pictures to encode: smooth ones as clouds are, and radiance with the values that are hard to store.
#pragma once
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "encode/encode.h"

namespace cloudscape {

inline Frame empty_frame(ImageSize size_px) {
  Frame frame;
  frame.request.size_px = size_px;
  frame.request.cloudscape = std::make_shared<const Cloudscape>();
  return frame;
}

// A gradient with waves of different lengths in the three channels; alpha 77 must never reach a file.
inline Frame display_frame(ImageSize size_px) {
  Frame frame = empty_frame(size_px);
  for (int y = 0; y < size_px.height; ++y)
    for (int x = 0; x < size_px.width; ++x) {
      for (const double wavelength_px : {40.0, 65.0, 90.0})
        frame.display_rgba.push_back(
            static_cast<std::uint8_t>(128 + 90 * std::sin(2 * std::numbers::pi * (x + 0.5 * y) / wavelength_px)));
      frame.display_rgba.push_back(77);
    }
  return frame;
}

// Values that half floats can hold only rounded, and sky (infinite depth) in every third pixel.
inline Frame radiance_frame(ImageSize size_px) {
  Frame frame = empty_frame(size_px);
  frame.request.content = FrameContent::radiance;
  for (int i = 0; i < size_px.width * size_px.height; ++i) {
    for (const float scale : {0.1f, 1.0f, 7.3f})
      frame.radiance_rgba.push_back(scale * static_cast<float>(i + 1) / 3.0f);
    frame.radiance_rgba.push_back(1.0f / static_cast<float>(i + 1));
    frame.depth_m.push_back(i % 3 == 0 ? std::numeric_limits<float>::infinity() : 1000.1f + static_cast<float>(i));
  }
  return frame;
}

inline Encoding encoding_of(ImageFormat format) {
  Encoding encoding;
  encoding.format = format;
  return encoding;
}

}  // namespace cloudscape
