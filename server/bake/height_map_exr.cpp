// Height maps of one-channel OpenEXR.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include <exception>

#include "bake/height_map.h"
#include "core/error.h"

namespace cloudscape::bake::detail {
namespace {

// The one channel's name; integers are no heights.
std::string channel_of(const Imf::Header& header) {
  std::string name;
  int count = 0;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel, ++count) {
    const Imf::Channel& sampled = channel.channel();
    if (sampled.type == Imf::UINT || sampled.xSampling != 1 || sampled.ySampling != 1)
      throw Error("has a channel of whole numbers or a subsampled one: write it with one channel of float or half");
    name = channel.name();
  }
  if (count != 1) throw Error("has " + std::to_string(count) + " channels: write it with one, of float or half");
  return name;
}

HeightMap read(const std::filesystem::path& path) {
  Imf::InputFile file(path.c_str(), 0);
  const Imath::Box2i window = file.header().dataWindow();
  const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
  const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
  check_size(width, height);
  HeightMap map{static_cast<int>(width), static_cast<int>(height), {}};
  const std::string channel = channel_of(file.header());
  map.values.resize(static_cast<std::size_t>(width * height));
  Imf::FrameBuffer buffer;
  buffer.insert(channel, Imf::Slice::Make(Imf::FLOAT, map.values.data(), window));
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  return map;
}

}  // namespace

HeightMap read_exr_height_map(const std::filesystem::path& path) {
  try {
    return read(path);
  } catch (const Error&) {
    throw;
  } catch (const std::exception&) {  // its text names the whole path, which is none of a client's business
    throw Error("is damaged or no EXR: write it anew");
  }
}

}  // namespace cloudscape::bake::detail
