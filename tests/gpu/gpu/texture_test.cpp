// Texels go to the device and come back unchanged; sampling, ownership, and uniform blocks.
#include "gpu/texture.h"

#include <gmock/gmock.h>

#include <array>
#include <glm/glm.hpp>
#include <limits>
#include <numeric>
#include <type_traits>

#include "core/error.h"
#include "fixture.h"
#include "gpu/pass.h"
#include "gpu/readback.h"
#include "shaders/shared/block.glsl"

namespace cloudscape::gpu {
namespace {

template <class T>
constexpr bool move_only = std::is_nothrow_move_constructible_v<T>&& std::is_nothrow_move_assignable_v<T> &&
                           !std::is_copy_constructible_v<T> && !std::is_copy_assignable_v<T>;
static_assert(move_only<Texture> && move_only<UniformBuffer> && move_only<Program> && move_only<Readback> &&
              move_only<Timer>);

// Bytes below 0x78, so that no half or float among them is a NaN, which a driver may alter.
std::vector<std::uint8_t> pattern(std::size_t count) {
  std::vector<std::uint8_t> bytes(count);
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>((i * 37 + i / 251) % 0x78);
  return bytes;
}

class EachFormat : public GpuTest, public testing::WithParamInterface<Format> {};
INSTANTIATE_TEST_SUITE_P(Formats, EachFormat,
                         testing::Values(Format::rgba8, Format::r8, Format::r16f, Format::rg16f, Format::rgba16f,
                                         Format::rgba32f, Format::r32f, Format::rg32f),
                         [](const auto& info) { return std::string(name_of(info.param)); });

TEST_P(EachFormat, ComesBackAsItWasIn2dAnd3dOfOddSizes) {
  Texture flat(GetParam(), 7, 5, "flat"), volume(GetParam(), 5, 3, 7, "volume"), thin(GetParam(), 3, 5, 1, "thin");
  for (Texture* texture : {&flat, &volume, &thin}) {
    const auto texels = pattern(texture->bytes());
    texture->upload(texels);
    EXPECT_EQ(texture->download(), texels);
    EXPECT_EQ(Readback(*texture).take(), texels);
    texture->clear();
    EXPECT_EQ(texture->download(), std::vector<std::uint8_t>(texels.size(), 0));
  }
  EXPECT_EQ(volume.bytes(), 105u * static_cast<std::size_t>(bytes_per_texel(GetParam())));
  EXPECT_EQ(format_from(name_of(GetParam())), GetParam());
}

class TextureTest : public GpuTest {
 protected:
  // A texture of one row (0, 1), sampled at `u`.
  float sampled(Filter filter, Wrap wrap, const std::string& u) {
    folder_.write("sample.glsl",
                  "layout(binding = 0) uniform sampler2D row;\nPassOutput shade(ivec2 pixel) { return "
                  "PassOutput(texture(row, vec2(" +
                      u + ", 0.5))); }\n");
    ShaderLibrary library(folder_.path());
    Texture row(Format::r32f, 2, 1, "row"), target(Format::r32f, 1, 1, "target");
    const std::array<float, 2> texels = {0.0f, 1.0f};
    const auto bytes = std::as_bytes(std::span(texels));
    row.upload({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    row.sample_with(filter, wrap);
    const std::array<const Texture*, 1> targets = {&target};
    const std::array textures = {Binding{0, &row}};
    ScreenPass(context(), library, "sample.glsl", {Format::r32f}).run({0, 0, 1, 1}, targets, textures);
    return as_numbers<float>(target.download()).front();
  }
  ShaderFolder folder_;
};

TEST_F(TextureTest, FiltersAndWrapsAsAsked) {
  EXPECT_EQ(sampled(Filter::nearest, Wrap::clamp, "0.45"), 0.0f);
  EXPECT_NEAR(sampled(Filter::linear, Wrap::clamp, "0.45"), 0.4f, 0.01f);
  EXPECT_EQ(sampled(Filter::nearest, Wrap::clamp, "1.2"), 1.0f);
  EXPECT_EQ(sampled(Filter::nearest, Wrap::repeat, "1.2"), 0.0f);
  EXPECT_NEAR(sampled(Filter::linear, Wrap::repeat, "0.0"), 0.5f, 0.01f);
}

TEST_F(TextureTest, RefusesTheWrongAmountOfTexelsAndImpossibleSizes) {
  Texture texture(Format::r8, 3, 3, "three");
  EXPECT_THROW(texture.upload(pattern(8)), Error);
  EXPECT_THROW(Texture(Format::r8, 0, 3, "none"), Error);
  EXPECT_THROW(Texture(Format::r8, 3, 3, 0, "flat"), Error);
  try {
    Texture(Format::r8, std::numeric_limits<int>::max(), 1, "endless");
    FAIL() << "it was made";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("'endless' of 2147483647x1 texels in r8"));
  }
  EXPECT_THROW(format_from("rgb9"), InvalidInput);
}

TEST_F(TextureTest, AMovedFromTextureIsEmpty) {
  Texture texture(Format::r8, 2, 2, "moved");
  texture.upload(pattern(4));
  Texture other = std::move(texture);
  EXPECT_FALSE(texture);
  EXPECT_TRUE(other);
  Texture assigned;
  EXPECT_FALSE(assigned);
  assigned = std::move(other);
  EXPECT_FALSE(other);
  EXPECT_EQ(assigned.download(), pattern(4));
}

using glm::ivec4;
using glm::mat4;
using glm::vec3;
using glm::vec4;
#define TEST_FIELDS(F) F(vec4, sun_direction) F(mat4, world_from_clip) F(ivec4, size_px) F(vec4, last)
DECLARE_BLOCK(TestBlock, test, 2, TEST_FIELDS)
#define BAD_FIELDS(F) F(vec3, three) F(vec4, four)
DECLARE_BLOCK(BadBlock, bad, 2, BAD_FIELDS)

class BlockTest : public GpuTest {
 protected:
  // A program whose pass declares the block as GLSL and returns `value`.
  static Program program_with(const std::string& declaration, const std::string& value) {
    return Program::compute(ShaderLibrary().load("shared/block.glsl", "layout(local_size_x = 1) in;\n",
                                                 declaration +
                                                     "layout(binding = 0, r32f) writeonly uniform image2D result;\n"
                                                     "void main() { imageStore(result, ivec2(0), vec4(" +
                                                     value + ")); }\n"),
                            "block test");
  }
};

TEST_F(BlockTest, TheDriverLaysItOutAsCppDoes) {
  const Program program = program_with(
      "#define TEST_FIELDS(F) F(vec4, sun_direction) F(mat4, world_from_clip) F(ivec4, size_px) F(vec4, last)\n"
      "DECLARE_BLOCK(TestBlock, test, 2, TEST_FIELDS)\n",
      "test.last.x");
  EXPECT_EQ(program.block_offsets("TestBlock"), TestBlock::offsets());
  EXPECT_THROW(program.block_offsets("NoBlock"), NotFound);
}

TEST_F(BlockTest, ATableThatStd140LaysOutOtherwiseIsNoticed) {
  const Program program =
      program_with("#define BAD_FIELDS(F) F(vec3, three) F(vec4, four)\nDECLARE_BLOCK(BadBlock, bad, 2, BAD_FIELDS)\n",
                   "bad.four.x");
  EXPECT_NE(program.block_offsets("BadBlock"), BadBlock::offsets());
}

TEST_F(BlockTest, ShadersReadWhatWasUploaded) {
  ShaderFolder folder;
  folder.write("pass.glsl",
               "layout(std140, binding = 2) uniform TestBlock { vec4 a; mat4 m; ivec4 size_px; vec4 last; } test;\n"
               "PassOutput shade(ivec2 pixel) { return PassOutput(test.last * float(test.size_px.y)); }\n");
  ShaderLibrary library(folder.path());
  UniformBlock<TestBlock> block("test");
  TestBlock values{};
  values.size_px.y = 3;
  values.last = vec4(1, 2, 3, 4);
  block.upload(values);
  block.bind();
  const Texture target(Format::rgba32f, 1, 1, "target");
  const std::array<const Texture*, 1> targets = {&target};
  for (const PassExecution execution : {PassExecution::compute, PassExecution::fragment}) {
    ScreenPass(execution, library, "pass.glsl", {Format::rgba32f}).run({0, 0, 1, 1}, targets, {});
    EXPECT_EQ(as_numbers<float>(target.download()), (std::vector<float>{3, 6, 9, 12}));
  }
  UniformBuffer small(16, "small");
  EXPECT_THROW(small.upload(std::as_bytes(std::span(&values, 1))), Error);
}

}  // namespace
}  // namespace cloudscape::gpu
