// JPEG decoding.
#include "viewer/picture.h"

#include <turbojpeg.h>

#include <string>
#include <utility>

#include "core/error.h"

namespace cloudscape::viewer {

JpegDecoder::JpegDecoder() : decompressor_(nullptr, tjDestroy) { start(); }

void JpegDecoder::start() {
  decompressor_.reset(tjInitDecompress());
  if (!decompressor_) throw Error("JPEG cannot be decoded: TurboJPEG did not start.");
}

void JpegDecoder::refuse(const wire::FrameHeader& header, const std::string& why) {
  start();  // a decompressor that failed inside a header goes on from there with the next image (TurboJPEG 2.1.5)
  throw Error("Frame " + std::to_string(header.frame_id) + " cannot be shown: " + why + ".");
}

Picture JpegDecoder::decode(ReceivedFrame frame) {
  const Time begin = std::chrono::steady_clock::now();
  const wire::FrameHeader& header = frame.header;
  const std::span<const std::uint8_t> image = frame.image();
  const auto size = static_cast<unsigned long>(image.size());
  if (header.image_format != static_cast<std::uint8_t>(ImageFormat::jpeg)) refuse(header, "it is not a JPEG");
  int width = 0, height = 0, subsampling = 0, colour_space = 0;
  if (tjDecompressHeader3(decompressor_.get(), image.data(), size, &width, &height, &subsampling, &colour_space) != 0)
    refuse(header, tjGetErrorStr2(decompressor_.get()));
  if (width != header.width_px || height != header.height_px)
    refuse(header, "it has not the size that its header says");
  std::vector<std::uint8_t> bgrx(std::size_t{4} * width * height);
  if (tjDecompress2(decompressor_.get(), image.data(), size, bgrx.data(), width, 0, height, TJPF_BGRX,
                    TJFLAG_STOPONWARNING) != 0)
    refuse(header, tjGetErrorStr2(decompressor_.get()));
  return {std::move(frame), std::move(bgrx), milliseconds_between(begin, std::chrono::steady_clock::now())};
}

}  // namespace cloudscape::viewer
