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

// One letter each.
std::string channels_of(ShapeFormat format) {
  constexpr const char* names[] = {"RGBA", "Y", "RG"};
  return names[static_cast<std::size_t>(format)];
}

// Value `index` of the texels, all channels counted.
half value_at(std::span<const std::uint8_t> texels, std::size_t index, ShapeFormat format) {
  if (format == ShapeFormat::rgba8) return half(static_cast<float>(texels[index]) / 255.0F);
  half value;
  value.setBits(static_cast<std::uint16_t>(texels[2 * index] | texels[2 * index + 1] << 8));
  return value;
}

std::vector<half> arranged(std::span<const std::uint8_t> texels, const Layout& layout, ShapeFormat format) {
  const std::size_t channels = channels_of(format).size();
  std::vector<half> pixels(static_cast<std::size_t>(layout.width()) * layout.height() * channels, half(0.0F));
  std::size_t value = 0;
  for (int z = 0; z < layout.depth; ++z) {
    for (int y = 0; y < layout.side; ++y) {
      const std::size_t row = static_cast<std::size_t>(z / layout.columns * layout.side + layout.side - 1 - y);
      std::size_t out = channels * (row * layout.width() + static_cast<std::size_t>(z % layout.columns * layout.side));
      for (std::size_t i = 0; i < channels * layout.side; ++i) pixels[out++] = value_at(texels, value++, format);
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

std::vector<std::uint8_t> slice_atlas_exr(std::span<const std::uint8_t> texels, int side, int depth,
                                          const std::map<std::string, std::string>& attributes, ShapeFormat format) {
  const Layout layout = layout_of(side, depth);
  const auto texel_bytes = static_cast<std::size_t>(bytes_per_texel(format));
  if (texels.size() != static_cast<std::size_t>(side) * side * depth * texel_bytes)
    throw Error("a volume of " + std::to_string(texels.size()) + " bytes is not " + std::to_string(side) + "x" +
                std::to_string(side) + "x" + std::to_string(depth) + " texels in " + std::string(name_of(format)));
  std::vector<half> pixels = arranged(texels, layout, format);
  Imf::Header header = header_of(layout, attributes);
  Imf::FrameBuffer buffer;
  const std::string names = channels_of(format);
  const std::size_t stride = names.size() * sizeof(half);
  for (std::size_t i = 0; i < names.size(); ++i) {
    header.channels().insert(names.substr(i, 1), Imf::Channel(Imf::HALF));
    buffer.insert(names.substr(i, 1), Imf::Slice(Imf::HALF, reinterpret_cast<char*>(&pixels[i]), stride,
                                                 stride * static_cast<std::size_t>(layout.width())));
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
