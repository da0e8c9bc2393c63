// Checks that a frame holds what its format needs, and hands it to the format's encoder.
#include "encode/encode.h"

#include <chrono>
#include <string>

#include "core/enlarge.h"
#include "core/error.h"
#include "core/milliseconds.h"
#include "core/version.h"
#include "encode/formats.h"

namespace cloudscape::encode {
namespace {

void require_size(std::size_t size, std::size_t expected, const Frame& frame, const char* content, const char* format) {
  if (size == expected) return;
  const ImageSize& size_px = frame.request.size_px;
  throw Error(std::string("A frame of ") + std::to_string(size_px.width) + "x" + std::to_string(size_px.height) +
              " pixels with " + std::to_string(size) + " instead of " + std::to_string(expected) + " " + content +
              " values cannot be encoded as " + format + ": request the frame with the content that " + format +
              " needs.");
}

void check(const Frame& frame, ImageFormat format) {
  const ImageSize& size_px = frame.request.size_px;
  if (size_px.width < 1 || size_px.height < 1) throw Error("A frame without pixels cannot be encoded.");
  const std::size_t pixels = static_cast<std::size_t>(size_px.width) * size_px.height;
  const char* name = format == ImageFormat::jpeg ? "JPEG" : format == ImageFormat::png ? "PNG" : "EXR";
  if (format != ImageFormat::exr) return require_size(frame.display_rgba.size(), pixels * 4, frame, "display", name);
  require_size(frame.radiance_rgba.size(), pixels * 4, frame, "radiance", name);
  require_size(frame.depth_m.size(), pixels, frame, "depth", name);
  if (!frame.standard_error_rgb.empty())
    require_size(frame.standard_error_rgb.size(), pixels * 3, frame, "standard error", name);
  if (!frame.request.cloudscape) throw Error("A frame without its cloudscape cannot be encoded as EXR.");
}

Bytes encode_checked(const Frame& frame, const Encoding& encoding, std::size_t front) {
  switch (encoding.format) {
    case ImageFormat::jpeg:
      return encode_jpeg(frame, encoding, front);
    case ImageFormat::png:
      return encode_png(frame, front);
    case ImageFormat::exr:
      return encode_exr(frame, encoding, front);
  }
  throw Error("A frame cannot be encoded in an unknown image format.");
}

}  // namespace

EncodedFrame encode(const Frame& frame, const Encoding& encoding, std::size_t front) {
  const auto start = std::chrono::steady_clock::now();
  Frame larger;
  if (frame.enlargement) enlarge(larger = frame);
  const Frame& whole = frame.enlargement ? larger : frame;
  check(whole, encoding.format);
  EncodedFrame encoded{encode_checked(whole, encoding, front), front, encoding.format, 0};
  encoded.encode_ms = ms_since(start);
  return encoded;
}

const char* media_type(ImageFormat format) {
  switch (format) {
    case ImageFormat::jpeg:
      return "image/jpeg";
    case ImageFormat::png:
      return "image/png";
    case ImageFormat::exr:
      return "image/x-exr";
  }
  return "application/octet-stream";
}

std::string software() { return std::string("cloudscape ") + version; }

}  // namespace cloudscape::encode
