// The shape in its two formats: the same shape, but for the steps of eight bits.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/packing.hpp>

#include "bake/cache.h"
#include "core/bake_size.h"
#include "fixture.h"

namespace cloudscape::bake {
namespace {

constexpr std::array<double, 3> weights{0.9, 0.5, 0.3};

BakeRecipe mixed_recipe(int resolution = 16) {
  BakeRecipe recipe = small_recipe();
  recipe.resolution = resolution;
  recipe.format = ShapeFormat::r16f;
  for (std::size_t i = 0; i < 3; ++i) recipe.noise.channels[i + 1].weight = weights[i];
  return recipe;
}

std::vector<float> shape_of(const BakedTexels& texels) {
  std::vector<float> shape;
  for (const std::uint16_t half : gpu::as_numbers<std::uint16_t>(texels.shape))
    shape.push_back(glm::unpackHalf1x16(half));
  return shape;
}

class ShapeFormat : public BakeTest {};

// How far rounding moves the mixture of eight-bit channels: half a code of each times what it is multiplied with.
TEST_F(ShapeFormat, MixesWhenItIsBakedWhatTheOtherMixesWhenItIsSampled) {
  const std::vector<std::uint8_t> eight_bits = bake(small_recipe()).shape;
  const std::vector<float> mixed = shape_of(bake(mixed_recipe()));
  ASSERT_EQ(mixed.size() * 4, eight_bits.size());
  float largest = 0;
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    const std::uint8_t* texel = &eight_bits[4 * i];
    double modulation = 1, weight_sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      modulation += weights[c] * (texel[c + 1] / 255.0 - 0.5);
      weight_sum += weights[c];
    }
    const double shape = texel[0] / 255.0, code = 0.55 / 255;
    const double tolerance =
        code * (std::abs(modulation) + weight_sum * (shape + code)) + shape * modulation * 0x1p-11 + 1e-6;
    ASSERT_NEAR(mixed[i], shape * modulation, tolerance) << i;
    largest = std::max(largest, mixed[i]);
  }
  EXPECT_GT(largest, 0.3);
}

// Eight bits have no more values than 256 for the shape; sixteen keep neighbours apart.
TEST_F(ShapeFormat, HasFinerSteps) {
  BakeRecipe plain = mixed_recipe(32);
  for (std::size_t i = 1; i < 4; ++i) plain.noise.channels[i].weight = 0;
  std::vector<float> values = shape_of(bake(plain));
  std::sort(values.begin(), values.end());
  EXPECT_GT(std::unique(values.begin(), values.end()) - values.begin(), 1500);
}

TEST_F(ShapeFormat, LeavesThresholdAndHeightsWhereTheyAre) {
  const BakedCloudscape eight_bits(bake(small_recipe())), mixed(bake(mixed_recipe()));
  for (const double coverage : {0.1, 0.3, 0.5, 0.9}) {
    const double threshold = eight_bits.threshold_for(coverage, weights);
    EXPECT_NEAR(mixed.threshold_for(coverage, {}), threshold, 2.0 / 255) << coverage;
    EXPECT_EQ(mixed.threshold_for(coverage, weights), mixed.threshold_for(coverage, {})) << "weights count only once";
  }
  const auto &of_eight = eight_bits.extent(weights).slice_maxima, &of_mixed = mixed.extent({}).slice_maxima;
  for (std::size_t z = 0; z < of_eight.size(); ++z) EXPECT_NEAR(of_mixed[z], of_eight[z], 2.0 / 255) << z;
}

TEST_F(ShapeFormat, ComesBackFromTheCache) {
  const CacheFolder folder;
  const BakeCache cache(folder.path(), 1ULL << 30);
  const BakedTexels texels = bake(mixed_recipe());
  EXPECT_EQ(texels.shape.size(), 2 * 16 * 16 * 16U);
  cache.store(texels);
  EXPECT_EQ(cache.load(mixed_recipe()), texels);
  EXPECT_FALSE(cache.load(small_recipe()));
  const BakedCloudscape baked(texels);
  EXPECT_EQ(baked.shape().format(), gpu::Format::r16f);
  EXPECT_EQ(baked.shape().download(), texels.shape);
}

TEST_F(ShapeFormat, TakesTheBytesThatWereForetold) {
  for (const VolumeFormat format : {VolumeFormat::rgba8, VolumeFormat::r16f})
    for (const VolumeKind kind : {VolumeKind::noise, VolumeKind::sphere}) {
      Cloudscape sky;
      sky.volume.kind = kind;
      sky.volume.format = format;
      sky.volume.resolution = sky.detail.resolution = 16;
      for (NoiseChannel& channel : sky.noise.channels) channel.frequency = 4, channel.octaves = 1;
      EXPECT_EQ(BakedCloudscape(bake(bake_recipe(sky))).bytes(), bake_bytes(sky));
    }
}

}  // namespace
}  // namespace cloudscape::bake
