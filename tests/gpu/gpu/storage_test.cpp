// Storage buffers, and passes that keep their state in them.
#include "gpu/storage.h"

#include <array>
#include <numeric>

#include "core/error.h"
#include "fixture.h"

namespace cloudscape::gpu {
namespace {

using StorageTest = GpuTest;

// Adds its number to each entry and counts who came; an image keeps the sum of its calls.
constexpr const char* counting_pass =
    "layout(local_size_x = 64) in;\n"
    "layout(std430, binding = 0) buffer Values { uint values[]; };\n"
    "layout(std430, binding = 1) buffer Count { uint count; };\n"
    "layout(binding = 0, r32f) uniform image2D sums;\n"
    "void main() {\n"
    "  uint i = gl_GlobalInvocationID.x;\n"
    "  if (i >= uint(values.length())) return;\n"
    "  values[i] += i;\n"
    "  atomicAdd(count, 1u);\n"
    "  if (i < 4u) imageStore(sums, ivec2(i, 0), imageLoad(sums, ivec2(i, 0)) + 0.5);\n"
    "}\n";

template <std::size_t count>
std::array<std::uint32_t, count> numbers_of(const StorageBuffer& buffer) {
  std::array<std::uint32_t, count> numbers{};
  buffer.download(std::as_writable_bytes(std::span(numbers)));
  return numbers;
}

TEST_F(StorageTest, BeginsWithZerosAndTakesBytes) {
  StorageBuffer buffer(16, "test");
  EXPECT_EQ(numbers_of<4>(buffer), (std::array<std::uint32_t, 4>{}));
  const std::array<std::uint32_t, 2> two{7, 9};
  buffer.upload(std::as_bytes(std::span(two)));
  EXPECT_EQ(numbers_of<4>(buffer), (std::array<std::uint32_t, 4>{7, 9, 0, 0}));
  const std::array<std::uint32_t, 5> five{};
  EXPECT_THROW(buffer.upload(std::as_bytes(std::span(five))), Error);
}

TEST_F(StorageTest, RefusesWhatNoDeviceHas) {
  EXPECT_THROW(StorageBuffer(0, "nothing"), Error);
  EXPECT_THROW(StorageBuffer(std::size_t{1} << 50, "everything"), Error);
}

TEST_F(StorageTest, PassesGoOnWhereTheLastOneEnded) {
  const ShaderFolder folder;
  folder.write("count.comp", counting_pass);
  ShaderLibrary library(folder.path());
  const StoragePass pass(library, "count.comp");
  const StorageBuffer values(100 * 4, "values"), count(4, "count");
  Texture sums(Format::r32f, 4, 1, "sums");
  sums.clear();
  const Texture* images[] = {&sums};
  values.bind(0), count.bind(1);
  for (int run = 0; run < 3; ++run) pass.run(100, {}, images);
  const auto numbers = numbers_of<100>(values);
  for (std::uint32_t i = 0; i < 100; ++i) EXPECT_EQ(numbers[i], 3 * i);
  EXPECT_EQ(numbers_of<1>(count)[0], 300U);
  EXPECT_EQ(as_numbers<float>(sums.download()), (std::vector<float>{1.5F, 1.5F, 1.5F, 1.5F}));
}

}  // namespace
}  // namespace cloudscape::gpu
