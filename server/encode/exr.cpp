// EXR through OpenEXR: scan lines, channels R G B A Z, ZIP compression.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfOutputFile.h>

#include <algorithm>
#include <cmath>
#include <exception>

#include "core/error.h"
#include "encode/exr_attributes.h"
#include "encode/formats.h"
#include "encode/memory_file.h"

namespace cloudscape::encode {
namespace {

constexpr std::array<const char*, 5> channels{"R", "G", "B", "A", "Z"};

// A finite value beyond half's range would become infinite, which in Z says "sky" and in a filter spoils its
// neighbours; it is clamped instead. Infinity itself is kept.
half to_half(float value) {
  constexpr float largest = 65504.0f;  // IEEE 754 binary16
  return half(std::isinf(value) ? value : std::clamp(value, -largest, largest));
}

// Five values a pixel: R G B A Z.
std::vector<half> half_pixels(const Frame& frame) {
  std::vector<half> pixels;
  pixels.reserve(frame.depth_m.size() * 5);
  for (std::size_t i = 0; i < frame.depth_m.size(); ++i) {
    for (std::size_t c = 0; c < 4; ++c) pixels.push_back(to_half(frame.radiance_rgba[i * 4 + c]));
    pixels.push_back(to_half(frame.depth_m[i]));
  }
  return pixels;
}

// OpenEXR takes pointers to mutable pixels for reading and for writing files alike.
template <class T>
char* base(const T* pixels) {
  return reinterpret_cast<char*>(const_cast<T*>(pixels));
}

Imf::FrameBuffer half_buffer(const std::vector<half>& pixels, int width) {
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < channels.size(); ++c)
    buffer.insert(channels[c],
                  Imf::Slice(Imf::HALF, base(pixels.data() + c), 5 * sizeof(half), 5 * sizeof(half) * width));
  return buffer;
}

Imf::FrameBuffer float_buffer(const Frame& frame, int width) {
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < 4; ++c)
    buffer.insert(channels[c], Imf::Slice(Imf::FLOAT, base(frame.radiance_rgba.data() + c), 4 * sizeof(float),
                                          4 * sizeof(float) * width));
  buffer.insert("Z", Imf::Slice(Imf::FLOAT, base(frame.depth_m.data()), sizeof(float), sizeof(float) * width));
  return buffer;
}

Bytes write_file(const Frame& frame, ExrType type, std::size_t front) {
  const auto [width, height] = frame.request.size_px;
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const char* channel : channels)
    header.channels().insert(channel, Imf::Channel(type == ExrType::half ? Imf::HALF : Imf::FLOAT));
  add_attributes(header, frame);

  const std::vector<half> halves = type == ExrType::half ? half_pixels(frame) : std::vector<half>{};
  MemoryFile memory(front);
  {
    Imf::OutputFile file(memory, header, 0);  // no threads of its own: the pool that calls encodes in parallel
    file.setFrameBuffer(type == ExrType::half ? half_buffer(halves, width) : float_buffer(frame, width));
    file.writePixels(height);
  }  // its destructor writes the table of line offsets
  return std::move(memory.bytes);
}

}  // namespace

Bytes encode_exr(const Frame& frame, const Encoding& encoding, std::size_t front) {
  try {
    return write_file(frame, encoding.exr_type, front);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(std::string("The EXR encoder failed: ") + error.what() + ".");
  }
}

}  // namespace cloudscape::encode
