// EXR through OpenEXR: scan lines, channels R G B A Z, of a path-traced picture also stderr.R G B, ZIP compression.
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

constexpr std::array<const char*, 4> channels{"R", "G", "B", "A"};
constexpr std::array<const char*, 3> error_channels{"stderr.R", "stderr.G", "stderr.B"};

// A finite value beyond half's range would become infinite, which in a filter spoils its neighbours; it is clamped
// instead. Infinity itself is kept.
half to_half(float value) {
  constexpr float largest = 65504.0f;  // IEEE 754 binary16
  return half(std::isinf(value) ? value : std::clamp(value, -largest, largest));
}

// R G B A.
std::vector<half> half_pixels(const Frame& frame) {
  std::vector<half> pixels;
  pixels.reserve(frame.radiance_rgba.size());
  for (const float value : frame.radiance_rgba) pixels.push_back(to_half(value));
  return pixels;
}

// OpenEXR takes pointers to mutable pixels for reading and for writing files alike.
template <class T>
char* base(const T* pixels) {
  return reinterpret_cast<char*>(const_cast<T*>(pixels));
}

// Channels R G B A, interleaved, and Z, which stays 32 bit: half would end at 65.5 km, within sight of any cloud.
// Standard errors stay so too: half has no digits left for what is a millionth of a radiance.
template <class T>
Imf::FrameBuffer frame_buffer(const std::vector<T>& rgba, Imf::PixelType type, const Frame& frame) {
  const int width = frame.request.size_px.width;
  const std::vector<float>&depth_m = frame.depth_m, &error = frame.standard_error_rgb;
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < 3 && !error.empty(); ++c)
    buffer.insert(error_channels[c],
                  Imf::Slice(Imf::FLOAT, base(error.data() + c), 3 * sizeof(float), 3 * sizeof(float) * width));
  for (std::size_t c = 0; c < 4; ++c)
    buffer.insert(channels[c], Imf::Slice(type, base(rgba.data() + c), 4 * sizeof(T), 4 * sizeof(T) * width));
  buffer.insert("Z", Imf::Slice(Imf::FLOAT, base(depth_m.data()), sizeof(float), sizeof(float) * width));
  return buffer;
}

Bytes write_file(const Frame& frame, ExrType type, std::size_t front) {
  const auto [width, height] = frame.request.size_px;
  const Imf::PixelType color_type = type == ExrType::half ? Imf::HALF : Imf::FLOAT;
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const char* channel : channels) header.channels().insert(channel, Imf::Channel(color_type));
  header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
  if (!frame.standard_error_rgb.empty())
    for (const char* channel : error_channels) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  add_attributes(header, frame);

  const std::vector<half> halves = type == ExrType::half ? half_pixels(frame) : std::vector<half>{};
  MemoryFile memory(front);
  {
    Imf::OutputFile file(memory, header, 0);  // no threads of its own: the pool that calls encodes in parallel
    file.setFrameBuffer(type == ExrType::half ? frame_buffer(halves, color_type, frame)
                                              : frame_buffer(frame.radiance_rgba, color_type, frame));
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
