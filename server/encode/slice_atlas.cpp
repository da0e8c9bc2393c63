#include "encode/slice_atlas.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <cmath>

#include "core/error.h"
#include "encode/memory_file.h"

namespace cloudscape::encode {
namespace {

struct Layout {
  int side, depth, columns, rows;
  int width() const { return side * columns; }
  int height() const { return side * rows; }
};

Layout layout_of(int side, int depth) {
  const int columns = static_cast<int>(std::ceil(std::sqrt(depth)));
  return {side, depth, columns, (depth + columns - 1) / columns};
}

std::vector<half> arranged(std::span<const std::uint8_t> rgba8, const Layout& layout) {
  std::vector<half> pixels(static_cast<std::size_t>(layout.width()) * layout.height() * 4, half(0.0F));
  std::size_t texel = 0;
  for (int z = 0; z < layout.depth; ++z) {
    for (int y = 0; y < layout.side; ++y) {
      const std::size_t row = static_cast<std::size_t>(z / layout.columns * layout.side + layout.side - 1 - y);
      std::size_t out = 4 * (row * layout.width() + static_cast<std::size_t>(z % layout.columns * layout.side));
      for (int i = 0; i < 4 * layout.side; ++i) pixels[out++] = half(static_cast<float>(rgba8[texel++]) / 255.0F);
    }
  }
  return pixels;
}

Imf::Header header_of(const Layout& layout, const std::map<std::string, std::string>& attributes) {
  Imf::Header header(layout.width(), layout.height());
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [name, text] : attributes) header.insert(name, Imf::StringAttribute(text));
  header.insert("slices", Imf::IntAttribute(layout.depth));
  header.insert("columns", Imf::IntAttribute(layout.columns));
  header.insert("side", Imf::IntAttribute(layout.side));
  return header;
}

}  // namespace

std::vector<std::uint8_t> slice_atlas_exr(std::span<const std::uint8_t> rgba8, int side, int depth,
                                          const std::map<std::string, std::string>& attributes) {
  const Layout layout = layout_of(side, depth);
  if (rgba8.size() != static_cast<std::size_t>(side) * side * depth * 4)
    throw Error("a volume of " + std::to_string(rgba8.size()) + " bytes is not " + std::to_string(side) + "x" +
                std::to_string(side) + "x" + std::to_string(depth) + " RGBA texels");
  std::vector<half> pixels = arranged(rgba8, layout);
  Imf::Header header = header_of(layout, attributes);
  Imf::FrameBuffer buffer;
  const char* channels[] = {"R", "G", "B", "A"};
  for (std::size_t i = 0; i < 4; ++i) {
    header.channels().insert(channels[i], Imf::Channel(Imf::HALF));
    buffer.insert(channels[i], Imf::Slice(Imf::HALF, reinterpret_cast<char*>(&pixels[i]), 4 * sizeof(half),
                                          4 * sizeof(half) * static_cast<std::size_t>(layout.width())));
  }
  MemoryFile memory(0);
  {
    Imf::OutputFile file(memory, header, 0);
    file.setFrameBuffer(buffer);
    file.writePixels(layout.height());
  }
  return std::move(memory.bytes);
}

}  // namespace cloudscape::encode
