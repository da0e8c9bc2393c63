// JPEG through TurboJPEG, with one compressor a thread.
#include <turbojpeg.h>

#include <algorithm>
#include <memory>

#include "core/error.h"
#include "encode/formats.h"

namespace cloudscape::encode {
namespace {

// The compressor and its scratch live as long as the thread: zeroing and returning a worst-case buffer (6 bytes a
// pixel) for each frame would cost as much as the compression, and what is never written here is never paged in.
class Compressor {
 public:
  // The result is valid until the next call.
  std::pair<const std::uint8_t*, std::size_t> compress(const Frame& frame, int quality, TJSAMP subsampling) {
    const ImageSize& size_px = frame.request.size_px;
    reserve(tjBufSize(size_px.width, size_px.height, subsampling));
    unsigned char* out = scratch_.get();
    unsigned long size = capacity_;
    if (!handle_ || tjCompress2(handle_.get(), frame.display_rgba.data(), size_px.width, 0, size_px.height, TJPF_RGBX,
                                &out, &size, subsampling, quality, TJFLAG_NOREALLOC) != 0)
      throw Error(std::string("The JPEG encoder failed: ") + tjGetErrorStr2(handle_.get()) + ".");
    return {out, size};
  }

 private:
  void reserve(std::size_t size) {
    if (size == static_cast<std::size_t>(-1)) throw Error("The picture is too large for JPEG: 65500 pixels a side.");
    if (size <= capacity_) return;
    scratch_ = std::make_unique_for_overwrite<unsigned char[]>(size);
    capacity_ = size;
  }

  struct Destroy {
    void operator()(void* handle) const { tjDestroy(handle); }
  };
  std::unique_ptr<void, Destroy> handle_{tjInitCompress()};
  std::unique_ptr<unsigned char[]> scratch_;
  std::size_t capacity_ = 0;
};

}  // namespace

Bytes encode_jpeg(const Frame& frame, const Encoding& encoding, std::size_t front) {
  thread_local Compressor compressor;
  const TJSAMP subsampling = encoding.chroma == ChromaSubsampling::half ? TJSAMP_420 : TJSAMP_444;
  const auto [image, size] = compressor.compress(frame, encoding.jpeg_quality, subsampling);
  Bytes bytes(front + size);
  std::copy_n(image, size, bytes.data() + front);
  return bytes;
}

}  // namespace cloudscape::encode
