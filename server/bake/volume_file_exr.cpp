// Volumes as slice atlases in OpenEXR, as encode/slice_atlas.h writes them.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include <cmath>
#include <exception>

#include "bake/volume_file.h"
#include "core/error.h"

namespace cloudscape::bake::detail {
namespace {

std::string channel_of(const Imf::Header& header) {
  for (const char* name : {"Y", "R"})
    if (const Imf::Channel* channel = header.channels().findChannel(name)) {
      if (channel->type == Imf::UINT || channel->xSampling != 1 || channel->ySampling != 1)
        throw UnusableFile("has a channel of whole numbers or a subsampled one: write it with one of float or half");
      return name;
    }
  throw UnusableFile("has no channel Y and no channel R: write the densities into Y");
}

Voxels read(const std::filesystem::path& path, const glm::ivec3& size) {
  Imf::InputFile file(path.c_str(), 0);
  const Imath::Box2i window = file.header().dataWindow();
  const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
  const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
  const int columns = static_cast<int>(std::ceil(std::sqrt(size.z))), rows = (size.z + columns - 1) / columns;
  if (width != std::int64_t{columns} * size.x || height != std::int64_t{rows} * size.y)
    throw UnusableFile("has " + std::to_string(width) + "x" + std::to_string(height) + " pixels, and " +
                       std::to_string(size.z) + " slices of " + std::to_string(size.x) + "x" + std::to_string(size.y) +
                       " voxels in " + std::to_string(columns) + " columns have " + std::to_string(columns * size.x) +
                       "x" + std::to_string(rows * size.y) + ": correct volume.grid.size");
  const std::string channel = channel_of(file.header());
  std::vector<float> pixels(static_cast<std::size_t>(width * height));
  Imf::FrameBuffer buffer;
  buffer.insert(channel, Imf::Slice::Make(Imf::FLOAT, pixels.data(), window));
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  Voxels voxels{size, {}};
  voxels.densities.reserve(count_of(size));
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y) {
      const std::int64_t row = std::int64_t{z / columns} * size.y + size.y - 1 - y;
      const auto begin = pixels.begin() + row * width + std::int64_t{z % columns} * size.x;
      voxels.densities.insert(voxels.densities.end(), begin, begin + size.x);
    }
  return voxels;
}

}  // namespace

Voxels read_exr_volume(const std::filesystem::path& path, const glm::ivec3& size) {
  try {
    return read(path, size);
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {  // its text names the whole path, which is none of a client's business
    throw UnusableFile("is damaged or no EXR: write it anew");
  }
}

}  // namespace cloudscape::bake::detail
