// A volume's slices in one EXR: every texel where the header says, and attributes that tell how to find it.
#include "encode/slice_atlas.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>

#include "core/error.h"

namespace cloudscape {
namespace {

class Bytes : public Imf::IStream {
 public:
  explicit Bytes(const std::vector<std::uint8_t>& bytes) : IStream("memory"), bytes_(bytes) {}
  bool read(char out[], int size) override {
    if (position_ + size > bytes_.size()) throw std::runtime_error("the file ends early");
    std::memcpy(out, bytes_.data() + position_, size);
    position_ += size;
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  const std::vector<std::uint8_t>& bytes_;
  std::uint64_t position_ = 0;
};

struct Atlas {
  Imf::Header header;
  std::size_t width, height;
  std::array<std::vector<float>, 4> channels;  // R G B A
};

Atlas decode(const std::vector<std::uint8_t>& exr) {
  Bytes bytes(exr);
  Imf::InputFile file(bytes);
  const Imath::Box2i window = file.header().dataWindow();
  Atlas atlas{file.header(), window.max.x + 1UL, window.max.y + 1UL, {}};
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < 4; ++c) {
    atlas.channels[c].resize(atlas.width * atlas.height);
    buffer.insert(std::string(1, "RGBA"[c]),
                  Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(atlas.channels[c].data()), 4, 4 * atlas.width));
  }
  file.setFrameBuffer(buffer);
  file.readPixels(0, window.max.y);
  return atlas;
}

std::vector<std::uint8_t> volume(std::size_t side, std::size_t depth) {
  std::vector<std::uint8_t> texels(4 * side * side * depth);
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::uint8_t>(i * 167 + i / 256 * 31);
  return texels;
}

int integer(const Atlas& atlas, const char* name) {
  return atlas.header.typedAttribute<Imf::IntAttribute>(name).value();
}

// Reads each texel by what the attributes say alone. Halves of 0..1 are good to 2^-12, an eighth of an eight-bit code.
void expect_every_texel(const std::vector<std::uint8_t>& texels, const Atlas& atlas) {
  const auto side = static_cast<std::size_t>(integer(atlas, "side"));
  const auto columns = static_cast<std::size_t>(integer(atlas, "columns"));
  for (std::size_t i = 0; i < texels.size() / 4; ++i) {
    const std::size_t x = i % side, north = i / side % side, z = i / side / side;
    const std::size_t column = z % columns * side + x;
    const std::size_t row = z / columns * side + (side - 1 - north);
    for (std::size_t c = 0; c < 4; ++c)
      ASSERT_NEAR(atlas.channels[c][row * atlas.width + column], texels[4 * i + c] / 255.0, 0x1p-12)
          << x << ' ' << north << ' ' << z << ' ' << c;
  }
}

TEST(SliceAtlas, HoldsEveryTexelWhereItSays) {
  struct {
    int side, depth, columns, rows;
  } const cases[] = {{8, 16, 4, 4}, {5, 7, 3, 3}, {4, 5, 3, 2}, {16, 1, 1, 1}, {1, 1, 1, 1}, {3, 2, 2, 1}};
  for (const auto [side, depth, columns, rows] : cases) {
    const auto texels = volume(side, depth);
    const Atlas atlas = decode(encode::slice_atlas_exr(texels, side, depth, {}));
    EXPECT_EQ(integer(atlas, "side"), side);
    EXPECT_EQ(integer(atlas, "slices"), depth);
    EXPECT_EQ(integer(atlas, "columns"), columns);
    EXPECT_EQ(atlas.width, static_cast<std::size_t>(side * columns));
    EXPECT_EQ(atlas.height, static_cast<std::size_t>(side * rows));
    expect_every_texel(texels, atlas);
  }
}

TEST(SliceAtlas, LeavesUnusedCellsBlack) {
  const Atlas atlas = decode(encode::slice_atlas_exr(std::vector<std::uint8_t>(4 * 2 * 2 * 3, 255), 2, 3, {}));
  for (std::size_t y = 2; y < 4; ++y)
    for (std::size_t x = 2; x < 4; ++x)
      for (const auto& channel : atlas.channels) EXPECT_EQ(channel[y * atlas.width + x], 0);
}

// Eight bits survive the way through halves.
TEST(SliceAtlas, GivesBackEveryEightBitValue) {
  std::vector<std::uint8_t> texels(4 * 8 * 8);
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::uint8_t>(i);
  const Atlas atlas = decode(encode::slice_atlas_exr(texels, 8, 1, {}));
  for (std::size_t i = 0; i < 64; ++i)
    for (std::size_t c = 0; c < 4; ++c)
      EXPECT_EQ(std::lround(255 * atlas.channels[c][(7 - i / 8) * 8 + i % 8]), texels[4 * i + c]);
}

TEST(SliceAtlas, CarriesItsAttributes) {
  const Atlas atlas =
      decode(encode::slice_atlas_exr(volume(2, 2), 2, 2, {{"recipe", "{\"seed\":1}"}, {"texture", "shape"}}));
  EXPECT_EQ(atlas.header.typedAttribute<Imf::StringAttribute>("recipe").value(), "{\"seed\":1}");
  EXPECT_EQ(atlas.header.typedAttribute<Imf::StringAttribute>("texture").value(), "shape");
  for (const char* name : {"R", "G", "B", "A"}) EXPECT_EQ(atlas.header.channels()[name].type, Imf::HALF) << name;
}

// One channel of halves comes out bit for bit.
TEST(SliceAtlas, HoldsAVolumeOfHalves) {
  std::vector<std::uint8_t> texels;
  for (int i = 0; i < 3 * 3 * 2; ++i) {
    const half value(0.37F * static_cast<float>(i) - 1);
    texels.push_back(static_cast<std::uint8_t>(value.bits() & 0xff));
    texels.push_back(static_cast<std::uint8_t>(value.bits() >> 8));
  }
  const std::vector<std::uint8_t> exr = encode::slice_atlas_exr(texels, 3, 2, {}, ShapeFormat::r16f);
  Bytes bytes(exr);
  Imf::InputFile file(bytes);
  ASSERT_EQ(file.header().dataWindow().max.x, 5);
  std::vector<half> pixels(6 * 3);
  Imf::FrameBuffer buffer;
  buffer.insert("Y", Imf::Slice(Imf::HALF, reinterpret_cast<char*>(pixels.data()), sizeof(half), 6 * sizeof(half)));
  file.setFrameBuffer(buffer);
  file.readPixels(0, 2);
  EXPECT_EQ(++file.header().channels().begin(), file.header().channels().end());
  for (std::size_t i = 0; i < 18; ++i) {
    const std::size_t x = i % 3, north = i / 3 % 3, z = i / 9;
    EXPECT_EQ(pixels[(2 - north) * 6 + 3 * z + x].bits(), half(0.37F * static_cast<float>(i) - 1).bits()) << i;
  }
}

// Of several layers: coverage in red, density in green.
TEST(SliceAtlas, HoldsAVolumeOfTwoHalves) {
  std::vector<std::uint8_t> texels;
  for (int i = 0; i < 2 * 2 * 2 * 2; ++i) {
    const half value(0.37F * static_cast<float>(i) - 1);
    texels.push_back(static_cast<std::uint8_t>(value.bits() & 0xff));
    texels.push_back(static_cast<std::uint8_t>(value.bits() >> 8));
  }
  const std::vector<std::uint8_t> exr = encode::slice_atlas_exr(texels, 2, 2, {}, ShapeFormat::rg16f);
  Bytes bytes(exr);
  Imf::InputFile file(bytes);
  std::vector<half> red(4 * 2), green(4 * 2);
  Imf::FrameBuffer buffer;
  for (auto& [name, pixels] : {std::pair{"R", &red}, std::pair{"G", &green}})
    buffer.insert(name, Imf::Slice(Imf::HALF, reinterpret_cast<char*>(pixels->data()), sizeof(half), 4 * sizeof(half)));
  file.setFrameBuffer(buffer);
  file.readPixels(0, 1);
  for (std::size_t i = 0; i < 8; ++i) {
    const std::size_t x = i % 2, north = i / 2 % 2, z = i / 4, pixel = (1 - north) * 4 + 2 * z + x;
    EXPECT_EQ(red[pixel].bits(), half(0.37F * static_cast<float>(2 * i) - 1).bits()) << i;
    EXPECT_EQ(green[pixel].bits(), half(0.37F * static_cast<float>(2 * i + 1) - 1).bits()) << i;
  }
}

TEST(SliceAtlas, RefusesAVolumeOfAnotherSize) {
  EXPECT_THROW(encode::slice_atlas_exr(volume(4, 4), 4, 5, {}), Error);
  EXPECT_THROW(encode::slice_atlas_exr({}, 1, 1, {}), Error);
  EXPECT_THROW(encode::slice_atlas_exr(volume(4, 4), 4, 4, {}, ShapeFormat::r16f), Error);
}

}  // namespace
}  // namespace cloudscape
