// A frame on its way to the display.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "viewer/meters.h"
#include "wire/messages.h"

namespace cloudscape::viewer {

// As it came: header and image.
struct ReceivedFrame {
  wire::FrameHeader header;
  std::vector<std::uint8_t> message;
  unsigned connection = 0;  // that it came by: frame ids begin anew with each
  std::span<const std::uint8_t> image() const { return std::span(message).subspan(wire::frame_header_bytes); }
};

struct Picture {
  ReceivedFrame frame;
  std::vector<std::uint8_t> bgrx;  // width * height * 4, top row first: SDL's RGB888 on a little-endian machine
  double decode_ms = 0;
};

// TurboJPEG, kept from picture to picture.
class JpegDecoder {
 public:
  JpegDecoder();
  // Throws Error if the image is damaged, is no JPEG, or has not the size that its header says.
  Picture decode(ReceivedFrame frame);

 private:
  void start();
  [[noreturn]] void refuse(const wire::FrameHeader& header, const std::string& why);
  std::unique_ptr<void, int (*)(void*)> decompressor_;
};

}  // namespace cloudscape::viewer
