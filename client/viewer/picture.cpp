// JPEG decoding.
#include "viewer/picture.h"

#include <turbojpeg.h>

#include <string>
#include <utility>

#include "core/error.h"

namespace cloudscape::viewer {

JpegDecoder::JpegDecoder() : decompressor_(tjInitDecompress(), tjDestroy) {
  if (!decompressor_) throw Error("JPEG cannot be decoded: TurboJPEG did not start.");
}

Picture JpegDecoder::decode(ReceivedFrame frame) {
  const Time start = std::chrono::steady_clock::now();
  const wire::FrameHeader& header = frame.header;
  const std::span<const std::uint8_t> image = frame.image();
  const std::string name = "Frame " + std::to_string(header.frame_id);
  if (header.image_format != static_cast<std::uint8_t>(ImageFormat::jpeg)) throw Error(name + " is not a JPEG.");
  int width = 0, height = 0, subsampling = 0, colour_space = 0;
  if (tjDecompressHeader3(decompressor_.get(), image.data(), static_cast<unsigned long>(image.size()), &width, &height,
                          &subsampling, &colour_space) != 0)
    throw Error(name + " is damaged: " + tjGetErrorStr2(decompressor_.get()) + ".");
  if (width != header.width_px || height != header.height_px) throw Error(name + " has not the size of its header.");
  std::vector<std::uint8_t> bgrx(std::size_t{4} * width * height);
  if (tjDecompress2(decompressor_.get(), image.data(), static_cast<unsigned long>(image.size()), bgrx.data(), width, 0,
                    height, TJPF_BGRX, TJFLAG_STOPONWARNING) != 0)
    throw Error(name + " is damaged: " + tjGetErrorStr2(decompressor_.get()) + ".");
  return {std::move(frame), std::move(bgrx), milliseconds_between(start, std::chrono::steady_clock::now())};
}

}  // namespace cloudscape::viewer
