// Results and times that come back later.
#include "gpu/readback.h"

#include <array>
#include <optional>

#include "core/error.h"
#include "fixture.h"
#include "gpu/pass.h"

namespace cloudscape::gpu {
namespace {

class ReadbackTest : public GpuTest {};

TEST_F(ReadbackTest, HoldsWhatTheTextureWasWhenItStarted) {
  Texture texture(Format::r8, 3, 1, "three");
  texture.upload(std::vector<std::uint8_t>{1, 2, 3});
  Readback readback(texture);
  texture.upload(std::vector<std::uint8_t>{4, 5, 6});
  EXPECT_EQ(readback.take(), (std::vector<std::uint8_t>{1, 2, 3}));
}

TEST_F(ReadbackTest, IsReadyOnceTheDeviceIsIdleAndTakenOnce) {
  Texture texture(Format::rgba8, 64, 64, "square");
  texture.clear();
  Readback empty, readback(texture);
  EXPECT_FALSE(empty.ready());
  context().finish();
  EXPECT_TRUE(readback.ready());
  Readback moved = std::move(readback);
  EXPECT_FALSE(readback);
  EXPECT_EQ(moved.take().size(), 64u * 64u * 4u);
  EXPECT_FALSE(moved);
  EXPECT_THROW(moved.take(), Error);
}

TEST_F(ReadbackTest, ManyMayBeUnderWayAndEndInAnyOrder) {
  Texture texture(Format::r8, 1, 1, "one");
  std::vector<Readback> readbacks;
  for (std::uint8_t i = 0; i < 20; ++i) {
    texture.upload(std::vector{i});
    readbacks.emplace_back(texture);
  }
  for (int i = 19; i >= 0; --i) EXPECT_EQ(readbacks[static_cast<std::size_t>(i)].take().front(), i);
}

TEST_F(ReadbackTest, BuffersAreUsedAgainAndFewAreKept) {
  const auto buffers = std::make_shared<ReadbackBuffers>();
  const unsigned first = buffers->take(64), other = buffers->take(64);
  EXPECT_NE(first, other);
  buffers->give_back(first, 64);
  EXPECT_NE(buffers->take(128), first) << "it has another size";
  EXPECT_EQ(buffers->take(64), first);
  for (int round = 0; round < 3; ++round) {
    Texture texture(Format::r32f, 4, 4, "numbers");
    std::vector<float> numbers(16, static_cast<float>(round));
    std::vector<std::uint8_t> bytes(64);
    std::memcpy(bytes.data(), numbers.data(), 64);
    texture.upload(bytes);
    EXPECT_EQ(Readback(texture, buffers).take(), bytes) << "not what another read into it before";
  }
  std::vector<Readback> many;
  const Texture texture(Format::r32f, 4, 4, "numbers");
  for (int i = 0; i < 20; ++i) many.emplace_back(texture, buffers);
  many.clear();
}

TEST_F(ReadbackTest, TimersNestAndGrowWithTheWork) {
  ShaderFolder folder;
  folder.write("slow.glsl",
               "PassOutput shade(ivec2 pixel) {\n"
               "  float sum = float(pixel.x);\n"
               "  for (int i = 0; i < 64; ++i) sum += sin(sum);\n"
               "  return PassOutput(vec4(sum));\n"
               "}\n");
  ShaderLibrary library(folder.path());
  const ScreenPass pass(context(), library, "slow.glsl", {Format::r32f});
  const Texture target(Format::r32f, 256, 256, "target");
  const std::array<const Texture*, 1> targets = {&target};
  Timer outer, inner;
  EXPECT_EQ(outer.milliseconds(), 0.0);
  outer.start();
  inner.start();
  pass.run({0, 0, 256, 256}, targets, {});
  inner.stop();
  for (int i = 0; i < 8; ++i) pass.run({0, 0, 256, 256}, targets, {});
  outer.stop();
  EXPECT_GT(inner.milliseconds(), 0.0);
  EXPECT_GT(outer.milliseconds(), 1.5 * inner.milliseconds());
  Timer moved = std::move(outer);
  EXPECT_GT(moved.milliseconds(), 0.0);
  moved.start();
  EXPECT_EQ(moved.milliseconds(), 0.0);
}

}  // namespace
}  // namespace cloudscape::gpu
