// What the device bakes is what the functions of shaders/lib say on the CPU.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/packing.hpp>

#include "bake/permutation.h"
#include "fixture.h"
#include "unit/shaders/glsl.h"

namespace cloudscape::bake {
namespace {

using glsl::ivec3, glsl::vec3;

// The channel of the shape texture, from its definition: fBm of both noises, spread and mixed.
float channel_of(const BakeRecipe& recipe, std::size_t index, vec3 position) {
  const NoiseChannel& channel = recipe.noise.channels[index];
  const int up = std::max(1, static_cast<int>(std::lround(channel.frequency * recipe.height_over_width)));
  const ivec3 cells(channel.frequency, channel.frequency, up);
  const float gain = static_cast<float>(channel.gain), share = static_cast<float>(channel.worley_mix);
  const auto salt = static_cast<std::uint32_t>(index);
  const float worley =
      glsl::worley_fbm(position, cells, channel.octaves, channel.lacunarity, gain, recipe.seed * 16 + salt);
  const float perlin = glsl::perlin_fbm(position, cells, channel.octaves, channel.lacunarity, gain);
  return (1 - share) * glsl::stretch(perlin, 0.25, 0.75) + share * glsl::stretch(worley, 0.3, 0.95);
}

// Red: thinned by height, and towers whose surface the noise pushes up and down.
float shape_of(const BakeRecipe& recipe, vec3 position) {
  const float noise = channel_of(recipe, 0, position);
  const float height = std::fmod(position.z, 1.0F);
  const glsl::vec2 tile = glm::fract(glsl::vec2(position));
  float value = noise * glsl::height_distribution(height, recipe.height_rise, recipe.height_fall);
  for (const Tower& tower : recipe.towers)
    value += (0.35 + 0.65 * noise) * glsl::tower_offset(tile, height / (0.45 + 0.85 * noise), glsl::vec2(tower.center),
                                                        tower.radius, tower.top, tower.strength);
  return glm::clamp(value, 0.0F, 1.0F);
}

std::array<float, 4> expected_shape(const BakeRecipe& recipe, vec3 position) {
  return {shape_of(recipe, position), channel_of(recipe, 1, position), channel_of(recipe, 2, position),
          channel_of(recipe, 3, position)};
}

// Rounding to eight bits is half a code; the rest is for a device that fuses multiplications and additions.
constexpr float code_tolerance = 0.5 + 0.07;

// The texel and its continuations beyond the tile's edges, every `stride`-th one.
void expect_agreement(const BakeRecipe& recipe, const std::vector<std::uint8_t>& shape, int stride) {
  glsl::current_permutation = permutation_table(recipe.seed);
  const int n = recipe.resolution;
  for (int texel = 0; texel < n * n * n; texel += stride)
    for (const vec3 tiles : {vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)}) {
      const vec3 center = vec3(texel % n, texel / n % n, texel / n / n) + 0.5F;
      const auto expected = expected_shape(recipe, center / static_cast<float>(n) + tiles);
      for (std::size_t c = 0; c < 4; ++c)
        ASSERT_NEAR(shape[4 * static_cast<std::size_t>(texel) + c], 255 * expected[c], code_tolerance)
            << "texel " << texel << " channel " << c << " tile " << tiles.x << tiles.y << tiles.z;
    }
}

class BakeAgreement : public BakeTest, public testing::WithParamInterface<BakedBy> {
 protected:
  BakeAgreement() { baker_ = Baker(GetParam(), shaders_); }
};
INSTANTIATE_TEST_SUITE_P(ByTheDeviceAndTheProcessor, BakeAgreement,
                         testing::Values(BakedBy::device, BakedBy::processor),
                         [](const auto& by) { return by.param == BakedBy::device ? "device" : "processor"; });

TEST_P(BakeAgreement, OfTheShapeTexture) {
  for (const std::uint32_t seed : {0U, 5U, 4294967295U}) {
    BakeRecipe recipe = small_recipe();
    recipe.seed = seed;
    expect_agreement(recipe, bake(recipe).shape, 3);
  }
}

// Lattices finer than the texels, too.
TEST_P(BakeAgreement, OfTheCoarsestTexture) {
  BakeRecipe recipe = small_recipe();
  recipe.noise.channels[2] = {0.5, 128, 2, 4, 0.5, 1};
  expect_agreement(recipe, bake(recipe).shape, 3);
}

TEST_P(BakeAgreement, OfADeepTileWithoutTowers) {
  BakeRecipe recipe = small_recipe();
  recipe.towers.clear();
  recipe.height_over_width = 2.7;  // 11 and 5 cells high: whole numbers, and no powers of two
  recipe.height_rise = 3;
  recipe.height_fall = 0;
  expect_agreement(recipe, bake(recipe).shape, 5);
}

// 64 texels a side are baked in several slabs.
TEST_P(BakeAgreement, DoesNotDependOnTheSlabs) {
  BakeRecipe recipe = small_recipe();
  recipe.resolution = 64;
  const std::unique_ptr<BakeJob> job = baker_.begin(recipe);
  int slabs = 1;
  double before = 0;
  for (; !job->advance(); ++slabs) {
    EXPECT_GT(job->progress(), before);
    EXPECT_LT(before = job->progress(), 1);
  }
  EXPECT_EQ(job->progress(), 1);
  ASSERT_GT(slabs, 1);
  expect_agreement(recipe, job->texels().shape, 97);
}

TEST_P(BakeAgreement, OfTheDetailTexture) {
  const BakeRecipe recipe = small_recipe();
  glsl::current_permutation = permutation_table(recipe.seed);
  const std::vector<std::uint8_t> detail = bake(recipe).detail;
  for (int texel = 0; texel < 16 * 16 * 16; texel += 3) {
    const vec3 position = (vec3(texel % 16, texel / 16 % 16, texel / 256) + 0.5F) / 16.0F;
    const float billows = glsl::worley_fbm(position, ivec3(2), 2, 2, 0.5, recipe.seed * 16 + 9);
    const float wisps = glsl::perlin_fbm(position, ivec3(2), 2, 2, 0.5);
    const std::uint8_t* baked = &detail[4 * static_cast<std::size_t>(texel)];
    ASSERT_NEAR(baked[0], 255 * glsl::stretch(billows, 0.3, 0.95), code_tolerance);
    ASSERT_NEAR(baked[1], 255 * glsl::stretch(wisps, 0.25, 0.75), code_tolerance);
  }
}

// Half floats of at most 1 round by at most 2^-12, or 2^-11 where a device cuts them off.
TEST_P(BakeAgreement, OfTheVariationMap) {
  const BakeRecipe recipe = small_recipe();
  glsl::current_permutation = permutation_table(recipe.seed);
  const auto halves = gpu::as_numbers<std::uint16_t>(bake(recipe).variation);
  ASSERT_EQ(halves.size(), 4U * 128 * 128);
  for (int texel = 0; texel < 128 * 128; texel += 7)
    for (int c = 0; c < 3; ++c) {
      const vec3 position((texel % 128 + 0.5F) / 128, (texel / 128 + 0.5F) / 128, 0.1F + 0.3F * c);
      const float expected = glsl::stretch(glsl::perlin_fbm(position, ivec3(4), 3, 2, 0.5), 0.3, 0.7);
      const float baked = glm::unpackHalf1x16(halves[4 * static_cast<std::size_t>(texel) + c]);
      ASSERT_NEAR(baked, expected, 0x1p-11F + 1e-5);
    }
}

}  // namespace
}  // namespace cloudscape::bake
