// Improved Perlin noise against the published reference, and what makes it usable in a tile.
#include <gtest/gtest.h>

#include "unit/shaders/glsl.h"
#include "unit/shaders/samples.h"

namespace cloudscape {
namespace {

using glsl::perlin_fbm, glsl::perlin_noise, glsl::vec3, glsl::ivec3;

const ivec3 whole(256);  // the reference's own period

// Perlin 2002 in double precision, the gradients as vectors and the corners summed one by one.
double reference_noise(double x, double y, double z) {
  static constexpr int gradients[16][3] = {{1, 1, 0},  {-1, 1, 0},  {1, -1, 0}, {-1, -1, 0}, {1, 0, 1},  {-1, 0, 1},
                                           {1, 0, -1}, {-1, 0, -1}, {0, 1, 1},  {0, -1, 1},  {0, 1, -1}, {0, -1, -1},
                                           {1, 1, 0},  {0, -1, 1},  {-1, 1, 0}, {0, -1, -1}};
  static const auto p = bake::permutation_table(0);
  const auto fade = [](double t) { return 6 * std::pow(t, 5) - 15 * std::pow(t, 4) + 10 * std::pow(t, 3); };
  const int cell[] = {static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)),
                      static_cast<int>(std::floor(z))};
  const double f[] = {x - cell[0], y - cell[1], z - cell[2]};
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    int hash = 0;
    double weight = 1, slope = 0;
    int bits[3];
    for (int axis = 0; axis < 3; ++axis) {
      bits[axis] = (corner >> axis) & 1;
      hash = p[(hash + cell[axis] + bits[axis]) & 255];
      weight *= bits[axis] == 1 ? fade(f[axis]) : 1 - fade(f[axis]);
    }
    for (int axis = 0; axis < 3; ++axis) slope += gradients[hash & 15][axis] * (f[axis] - bits[axis]);
    sum += weight * slope;
  }
  return sum;
}

struct Published {
  double x, y, z, value;
};
// The first four are published for the reference implementation, the others were computed with it.
const Published published[] = {{3.14L, 42, 7, 0.13691995878400012L},
                               {-4.20L, 10, 6, 0.14208000000000043L},
                               {0.5, 0.5, 0.5, -0.25},
                               {0.1L, 0.1L, 0.1L, 0.1861607143544832L},
                               {1.5, 2.5, 3.5, 0.125},
                               {0.25, 0.75, 0.125, -0.07060389698017389L},
                               {12.34L, 56.78L, 90.12L, 0.07834384344217528L},
                               {-0.5, -0.5, -0.5, -0.875},
                               {31.4159L, 27.1828L, 16.1803L, 0.03824968088405883L}};

TEST(Perlin, MeetsThePublishedValues) {
  for (const Published& at : published) {
    EXPECT_NEAR(reference_noise(at.x, at.y, at.z), at.value, 1e-12L);
    // Negative coordinates one period on, which is the same lattice.
    const auto wrapped = [](double x) { return static_cast<float>(x < 0 ? x + 256 : x); };
    const vec3 position(wrapped(at.x), wrapped(at.y), wrapped(at.z));
    EXPECT_NEAR(perlin_noise(position, whole), at.value, at.x < 0 ? 5e-5 : 2e-5) << at.x << ' ' << at.y << ' ' << at.z;
  }
}

// 32 bits hold a coordinate below 256 to 1.5e-5, but the same rounded coordinate goes to both.
TEST(Perlin, EqualsTheReferenceAllOverItsPeriod) {
  Samples samples;
  for (int i = 0; i < 20000; ++i) {
    const vec3 p = samples.in_box(vec3(0), vec3(256));
    ASSERT_NEAR(perlin_noise(p, whole), reference_noise(p.x, p.y, p.z), 2e-6) << p.x << ' ' << p.y << ' ' << p.z;
  }
}

TEST(Perlin, HasTheMomentsOfTheReference) {
  Samples samples;
  constexpr int count = 200000;
  double sum = 0, squares = 0;
  for (int i = 0; i < count; ++i) {
    const double value = perlin_noise(samples.in_box(vec3(0), vec3(256)), whole);
    ASSERT_LE(std::abs(value), 1.0364);  // the bound of 3D gradient noise with these gradients
    sum += value, squares += value * value;
  }
  EXPECT_NEAR(sum / count, 0, 0.003);  // five standard errors
  EXPECT_NEAR(squares / count, 0.0729, 0.0015);
}

TEST(Perlin, VanishesAtLatticePoints) {
  for (int x = 0; x < 32; ++x)
    for (int y = 0; y < 32; ++y) EXPECT_EQ(perlin_noise(vec3(x, y, 3 * x + y), ivec3(32, 32, 256)), 0);
}

// fade(t) = 10 t^3 + O(t^4): value, slope and curvature are 0 at 0, and by symmetry no slope or curvature at 1.
TEST(Perlin, FadesWithoutSlopeOrCurvatureAtTheEnds) {
  for (const double t : {1.0 / 64, 1.0 / 256, 1.0 / 1024}) {
    EXPECT_NEAR(glsl::perlin_fade(t) / (t * t * t), 10, 16 * t);
    EXPECT_NEAR(1 - static_cast<double>(glsl::perlin_fade(1 - t)), 10 * t * t * t, 16 * t * t * t * t + 2e-7);
  }
  EXPECT_EQ(glsl::perlin_fade(0), 0);
  EXPECT_EQ(glsl::perlin_fade(1), 1);
  EXPECT_EQ(glsl::perlin_fade(0.5), 0.5);
}

// Positions are multiples of 1/64, so that adding the period does not round.
TEST(Perlin, RepeatsAfterEveryPeriod) {
  for (const ivec3 period : {ivec3(4), ivec3(3, 5, 7), ivec3(16, 16, 1), ivec3(128, 1, 2)})
    for (int i = 0; i < 2000; ++i) {
      const vec3 p = vec3((i * 37) % (64 * period.x), (i * 101) % (64 * period.y), (i * 7) % (64 * period.z)) / 64.0F;
      const float value = perlin_noise(p, period);
      ASSERT_EQ(value, perlin_noise(p + vec3(period.x, 0, 0), period));
      ASSERT_EQ(value, perlin_noise(p + vec3(0, period.y, 0), period));
      ASSERT_EQ(value, perlin_noise(p + vec3(0, 0, period.z), period));
    }
}

// The slope of Perlin noise is bounded, so a step of 1/1024 across the seam may change little.
TEST(Perlin, HasNoStepAtTheSeam) {
  for (const ivec3 period : {ivec3(4), ivec3(3, 5, 7), ivec3(512, 2, 300)})
    for (int i = 0; i < 500; ++i) {
      const vec3 p(0, 0.37F + 0.01F * i * period.y / 512, 0.11F);
      const vec3 before = p + vec3(period.x - 1.0F / 1024, 0, 0);
      ASSERT_NEAR(perlin_noise(before, period), perlin_noise(p, period), 4.0F / 1024);
    }
}

// The unnormalized sum of four octaves at (.1, .2, .3), computed with the reference implementation.
TEST(PerlinFbm, SumsTheOctavesOfTheReference) {
  const float expected = 0.5 + 0.5 * 0.30662055100948477 / (1 + 0.5 + 0.25 + 0.125);
  EXPECT_NEAR(perlin_fbm(vec3(0.1, 0.2, 0.3) / 32.0F, ivec3(32), 4, 2, 0.5), expected, 1e-5);
}

TEST(PerlinFbm, TilesAndStaysInRange) {
  Samples samples;
  double sum = 0;
  for (int i = 0; i < 5000; ++i) {
    const vec3 p = vec3(ivec3(samples.in_box(vec3(0), vec3(256)))) / 256.0F;
    const float value = perlin_fbm(p, ivec3(4, 4, 3), 4, 2, 0.5);
    ASSERT_GE(value, 0);
    ASSERT_LE(value, 1);
    ASSERT_NEAR(value, perlin_fbm(p + vec3(1, 0, 0), ivec3(4, 4, 3), 4, 2, 0.5), 1e-6);
    ASSERT_NEAR(value, perlin_fbm(p + vec3(0, 1, 1), ivec3(4, 4, 3), 4, 2, 0.5), 2e-5);
    sum += value;
  }
  EXPECT_NEAR(sum / 5000, 0.5, 0.02);
}

}  // namespace
}  // namespace cloudscape
