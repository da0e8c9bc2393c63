#include "encode/exr_reader.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include <array>
#include <exception>

#include "core/error.h"

namespace cloudscape::encode {
namespace {

// The named channels, interleaved.
template <std::size_t count>
std::vector<float> read_channels(Imf::InputFile& file, const std::array<const char*, count>& names) {
  const Imath::Box2i window = file.header().dataWindow();
  const std::size_t width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
  std::vector<float> values(width * height * count);
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < count; ++c)
    buffer.insert(names[c], Imf::Slice::Make(Imf::FLOAT, values.data() + c, window, count * sizeof(float),
                                             count * sizeof(float) * width));
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  return values;
}

bool has_size(const Imf::InputFile& file, const ImageSize& size_px) {
  const Imath::Box2i window = file.header().dataWindow();
  return window.max.x - window.min.x + 1 == size_px.width && window.max.y - window.min.y + 1 == size_px.height;
}

Frame read(const std::filesystem::path& path, const ImageSize& size_px) {
  Imf::InputFile file(path.c_str(), 0);
  if (!has_size(file, size_px)) throw Error("it is not of the size that its name stands for");
  Frame frame;
  frame.request.size_px = size_px;
  frame.radiance_rgba = read_channels<4>(file, {"R", "G", "B", "A"});
  if (file.header().channels().findChannel("stderr.R"))
    frame.standard_error_rgb = read_channels<3>(file, {"stderr.R", "stderr.G", "stderr.B"});
  return frame;
}

}  // namespace

Frame read_exr(const std::filesystem::path& file, const ImageSize& size_px) {
  try {
    return read(file, size_px);
  } catch (const std::exception& error) {
    throw Error("The picture " + file.string() + " cannot be read (" + error.what() + "): remove it.");
  }
}

}  // namespace cloudscape::encode
