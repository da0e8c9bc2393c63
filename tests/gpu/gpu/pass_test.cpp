// Screen passes in both executions, volume passes, reload, and what goes wrong with them.
#include "gpu/pass.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "core/error.h"
#include "fixture.h"

namespace cloudscape::gpu {
namespace {

using testing::HasSubstr;

constexpr const char* position_pass =
    "PassOutput shade(ivec2 pixel) {\n"
    "  return PassOutput(vec4(vec2(pixel) / 64.0, 0.25, 1.0), vec4(float(pixel.x * 100 + pixel.y)));\n"
    "}\n";

struct Targets {
  Texture colour{Format::rgba8, 37, 21, "colour"}, number{Format::r32f, 37, 21, "number"};
  Targets() {
    colour.clear();
    number.clear();
  }
  std::array<const Texture*, 2> list() const { return {&colour, &number}; }
};

class PassTest : public GpuTest {
 protected:
  ScreenPass make(PassExecution execution, const std::string& text, std::vector<Format> formats) {
    folder_.write("pass.glsl", text);
    return {execution, library_, "pass.glsl", std::move(formats)};
  }
  ShaderFolder folder_;
  ShaderLibrary library_{folder_.path()};
};

class BothExecutions : public PassTest, public testing::WithParamInterface<PassExecution> {};
INSTANTIATE_TEST_SUITE_P(Executions, BothExecutions, testing::Values(PassExecution::compute, PassExecution::fragment),
                         [](const auto& info) {
                           return std::string(info.param == PassExecution::compute ? "compute" : "fragment");
                         });

TEST_P(BothExecutions, ShadesEachPixelOfTheRectAndNoOther) {
  const Targets targets;
  const ScreenPass pass = make(GetParam(), position_pass, {Format::rgba8, Format::r32f});
  pass.run({5, 3, 17, 11}, targets.list(), {});
  const auto numbers = as_numbers<float>(targets.number.download());
  for (int y = 0; y < 21; ++y)
    for (int x = 0; x < 37; ++x) {
      const bool inside = x >= 5 && x < 22 && y >= 3 && y < 14;
      ASSERT_EQ(numbers[static_cast<std::size_t>(y * 37 + x)], inside ? float(x * 100 + y) : 0.0f) << x << "," << y;
    }
}

TEST_P(BothExecutions, LeavesThePixelsThatAShaderLeaves) {
  Texture number(Format::r32f, 37, 21, "number");
  number.clear();
  const ScreenPass pass = make(GetParam(),
                               "#define PASS_LEAVES\n"
                               "bool leaves(ivec2 pixel) { return pixel.x < 5; }\n"
                               "PassOutput shade(ivec2 pixel) { return PassOutput(vec4(7.0)); }\n",
                               {Format::r32f});
  const std::array<const Texture*, 1> targets{&number};
  pass.run({0, 0, 37, 21}, targets, {});
  const auto numbers = as_numbers<float>(number.download());
  EXPECT_EQ(std::ranges::count(numbers, 0.0f), 5 * 21);
  EXPECT_EQ(std::ranges::count(numbers, 7.0f), 32 * 21);
}

// One pass marks tiles, the next shades them, and no others where passes are drawn.
TEST_P(BothExecutions, ShadesTheTilesThatAreMarked) {
  Texture first(Format::r32f, 37, 21, "first"), second(Format::r32f, 37, 21, "second");
  second.clear();
  const std::array<const Texture*, 1> written_first{&first}, written_second{&second};
  const ScreenPass marking =
      make(GetParam(),
           "layout(binding = 7, r32f) writeonly uniform image2D marks;\n"
           "PassOutput shade(ivec2 pixel) {\n"
           "  if (pixel == ivec2(10, 9) || pixel == ivec2(36, 20)) imageStore(marks, pixel >> 3, vec4(1.0));\n"
           "  return PassOutput(vec4(0.0));\n"
           "}\n",
           {Format::r32f});
  folder_.write("tiles.glsl", "PassOutput shade(ivec2 pixel) { return PassOutput(vec4(3.0)); }\n");
  const ScreenPass tiles(GetParam(), library_, "tiles.glsl", {Format::r32f}, "", Shades::rects_and_tiles);
  TileMarks marks(37, 21);
  for (int round = 0; round < 2; ++round) {  // marks of the round before are gone
    marks.begin();
    marking.run({0, 0, round == 0 ? 37 : 20, 21}, written_first, {});
    marks.end();
    second.clear();
    tiles.run_tiles(marks, written_second, {});
    const auto numbers = as_numbers<float>(second.download());
    const bool all = GetParam() == PassExecution::compute;
    for (int y = 0; y < 21; ++y)
      for (int x = 0; x < 37; ++x) {
        const bool marked = (x / 8 == 1 && y / 8 == 1) || (round == 0 && x / 8 == 4 && y / 8 == 2);
        ASSERT_EQ(numbers[static_cast<std::size_t>(y * 37 + x)], all || marked ? 3.0f : 0.0f) << x << "," << y;
      }
  }
  tiles.run({0, 0, 37, 21}, written_second, {});  // as any other pass
  EXPECT_EQ(std::ranges::count(as_numbers<float>(second.download()), 3.0f), 37 * 21);
}

TEST_P(BothExecutions, ClipsARectThatReachesOverTheEdges) {
  const Targets targets;
  const ScreenPass pass = make(GetParam(), position_pass, {Format::rgba8, Format::r32f});
  pass.run({-10, -10, 1000, 1000}, targets.list(), {});
  EXPECT_EQ(as_numbers<float>(targets.number.download()).back(), 3620.0f);
  pass.run({40, 0, 5, 5}, targets.list(), {});
}

TEST_P(BothExecutions, ReadsWhatAnEarlierPassWrote) {
  const Targets targets;
  const ScreenPass first = make(GetParam(), position_pass, {Format::rgba8, Format::r32f});
  const ScreenPass second = make(GetParam(),
                                 "layout(binding = 3) uniform sampler2D number;\n"
                                 "PassOutput shade(ivec2 pixel) {\n"
                                 "  return PassOutput(vec4(2.0 * texelFetch(number, pixel, 0).r));\n"
                                 "}\n",
                                 {Format::r32f});
  const Texture doubled(Format::r32f, 37, 21, "doubled");
  const std::array<const Texture*, 1> target = {&doubled};
  const std::array textures = {Binding{3, &targets.number}};
  first.run({0, 0, 37, 21}, targets.list(), {});
  second.run({0, 0, 37, 21}, target, textures);
  EXPECT_EQ(as_numbers<float>(doubled.download()).back(), 7240.0f);
}

TEST_P(BothExecutions, RefusesTargetsThatDoNotFit) {
  const Targets targets;
  const ScreenPass pass = make(GetParam(), position_pass, {Format::rgba8, Format::rgba16f});
  EXPECT_THROW(pass.run({0, 0, 8, 8}, targets.list(), {}), Error);
  const std::array<const Texture*, 1> one = {&targets.colour};
  EXPECT_THROW(pass.run({0, 0, 8, 8}, one, {}), Error);
  const Texture larger(Format::rgba16f, 38, 21, "larger"), fitting(Format::rgba16f, 37, 21, "fitting");
  const std::array<const Texture*, 2> unequal = {&targets.colour, &larger}, good = {&targets.colour, &fitting};
  EXPECT_THROW(pass.run({0, 0, 8, 8}, unequal, {}), Error);
  const std::array read_back = {Binding{0, &fitting}};
  EXPECT_THROW(pass.run({0, 0, 8, 8}, good, read_back), Error);
  EXPECT_NO_THROW(pass.run({0, 0, 8, 8}, good, {}));
}

TEST_F(PassTest, ComputeAndFragmentWriteTheSameBytes) {
  const Targets by_compute, by_fragment;
  const std::vector<Format> formats = {Format::rgba8, Format::r32f};
  make(PassExecution::compute, position_pass, formats).run({0, 0, 37, 21}, by_compute.list(), {});
  make(PassExecution::fragment, position_pass, formats).run({0, 0, 37, 21}, by_fragment.list(), {});
  EXPECT_EQ(by_compute.colour.download(), by_fragment.colour.download());
  EXPECT_EQ(by_compute.number.download(), by_fragment.number.download());
}

TEST_F(PassTest, ACompileErrorNamesTheIncludedFileAndItsLine) {
  folder_.write("lib/broken.glsl", "\n\nfloat broken() { return undeclared_name; }\n");
  for (const PassExecution execution : {PassExecution::compute, PassExecution::fragment}) try {
      make(execution,
           "#include \"lib/broken.glsl\"\nPassOutput shade(ivec2 p) { return PassOutput(vec4(broken())); }\n",
           {Format::rgba8});
      FAIL() << "it compiled";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("lib/broken.glsl:3:"));
      EXPECT_THAT(error.what(), HasSubstr("undeclared_name"));
    }
}

TEST_F(PassTest, ReloadKeepsTheOldProgramUntilTheFileIsMended) {
  const Texture target(Format::r32f, 8, 8, "target");
  const std::array<const Texture*, 1> list = {&target};
  const auto constant = [](const std::string& value) {
    return "PassOutput shade(ivec2 pixel) { return PassOutput(vec4(" + value + ")); }\n";
  };
  ScreenPass pass = make(context().execution(), constant("1.0"), {Format::r32f});
  const auto shaded_after = [&](const std::string& value) {
    folder_.write("pass.glsl", constant(value));
    pass.reload(library_);
    pass.run({0, 0, 8, 8}, list, {});
    return as_numbers<float>(target.download()).front();
  };
  EXPECT_EQ(shaded_after("2.0"), 2.0f);
  EXPECT_EQ(shaded_after("3.0 +"), 2.0f);
  EXPECT_EQ(shaded_after("4.0"), 4.0f);
}

TEST_F(PassTest, AVolumePassWritesExactlyTheSlicesItIsAskedFor) {
  folder_.write("volume.comp",
                "layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;\n"
                "layout(binding = 0, r32f) writeonly uniform image3D volume;\n"
                "void main() {\n"
                "  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, volume_pass.z_begin);\n"
                "  if (texel.z >= volume_pass.z_end) return;\n"
                "  imageStore(volume, texel, vec4(texel.x + 10 * texel.y + 100 * texel.z));\n"
                "}\n");
  Texture volume(Format::r32f, 5, 6, 9, "volume");
  volume.clear();
  const VolumePass pass(library_, "volume.comp");
  pass.run(volume, 2, 7, {});
  const auto numbers = as_numbers<float>(volume.download());
  for (int z = 0; z < 9; ++z)
    EXPECT_EQ(numbers[static_cast<std::size_t>((z * 6 + 5) * 5 + 4)], z >= 2 && z < 7 ? float(54 + 100 * z) : 0.0f);
  EXPECT_THROW(pass.run(volume, 0, 10, {}), Error);
}

}  // namespace
}  // namespace cloudscape::gpu
