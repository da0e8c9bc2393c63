// Cellular noise against a search through every feature point of the periodic domain.
#include <gtest/gtest.h>

#include <algorithm>

#include "unit/shaders/glsl.h"
#include "unit/shaders/samples.h"

namespace cloudscape {
namespace {

using glsl::worley_fbm, glsl::worley_noise, glsl::vec3, glsl::ivec3;

// Distance to the nearest feature point among all cells of the period and their copies around it.
double nearest_of_all(vec3 position, ivec3 period, std::uint32_t seed) {
  double nearest = 1e9;
  for (int z = -2 * period.z; z < 3 * period.z; ++z)
    for (int y = -period.y; y < 2 * period.y; ++y)
      for (int x = -period.x; x < 2 * period.x; ++x) {
        const ivec3 cell((x + period.x) % period.x, (y + period.y) % period.y, (z + 2 * period.z) % period.z);
        const glm::dvec3 point = glm::dvec3(x, y, z) + glm::dvec3(glsl::worley_point(cell, seed));
        nearest = std::min(nearest, glm::length(point - glm::dvec3(position)));
      }
  return nearest;
}

double distance_of(float value) { return (1 - static_cast<double>(value)) * std::sqrt(3.0L); }

// Up to a distance of 1 the 27 cells around must hold the nearest point; beyond it a farther cell may, rarely.
TEST(Worley, FindsTheNearestOfAllPoints) {
  Samples samples;
  int beyond = 0, count = 0;
  for (const ivec3 period : {ivec3(4), ivec3(2, 3, 5), ivec3(4, 4, 1), ivec3(1)})
    for (int i = 0; i < 1500; ++i, ++count) {
      const vec3 p = samples.in_box(vec3(0), vec3(period));
      const double truth = nearest_of_all(p, period, 7), found = distance_of(worley_noise(p, period, 7));
      ASSERT_GE(found, truth - 2e-6);
      if (truth <= 1)
        ASSERT_NEAR(found, truth, 4e-6);
      else
        ++beyond;
    }
  EXPECT_LT(beyond, count / 100);
}

TEST(Worley, IsOneAtAFeaturePoint) {
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y) {
      const ivec3 cell(x, y, (x + 3 * y) % 8);
      EXPECT_NEAR(worley_noise(vec3(cell) + glsl::worley_point(cell, 3), ivec3(8), 3), 1, 1e-6);
    }
}

// Mean and deviation of the nearest distance with one evenly spread point a cell, from four hundred thousand samples of
// an independent implementation.
TEST(Worley, HasTheMomentsOfJitteredPoints) {
  Samples samples;
  constexpr int count = 100000;
  double sum = 0, squares = 0;
  for (int i = 0; i < count; ++i) {
    const float value = worley_noise(samples.in_box(vec3(0), vec3(64)), ivec3(64), 1);
    ASSERT_GE(value, 0);
    ASSERT_LE(value, 1);
    const double distance = distance_of(value);
    sum += distance, squares += distance * distance;
  }
  const double mean = sum / count;
  EXPECT_NEAR(mean, 0.5207, 0.003);
  EXPECT_NEAR(std::sqrt(squares / count - mean * mean), 0.1719, 0.002);
}

TEST(Worley, RepeatsAfterEveryPeriod) {
  for (const ivec3 period : {ivec3(4), ivec3(3, 5, 7), ivec3(16, 16, 1)})
    for (int i = 0; i < 2000; ++i) {
      const vec3 p = vec3((i * 37) % (64 * period.x), (i * 101) % (64 * period.y), (i * 7) % (64 * period.z)) / 64.0F;
      const float value = worley_noise(p, period, 5);
      ASSERT_EQ(value, worley_noise(p + vec3(period.x, 0, 0), period, 5));
      ASSERT_EQ(value, worley_noise(p + vec3(0, period.y, period.z), period, 5));
    }
}

// A distance changes by no more than the way gone, so the value changes by at most that / sqrt(3), also across seams.
TEST(Worley, NeverChangesFasterThanTheWayGone) {
  Samples samples;
  const float step = 1.0 / 256;
  for (int i = 0; i < 5000; ++i) {
    vec3 p = samples.in_box(vec3(0), vec3(4, 4, 1));
    if (i % 2 == 0) p.x = 4 - step / 2;
    const float here = worley_noise(p, ivec3(4, 4, 1), 5),
                there = worley_noise(p + vec3(step, 0, 0), ivec3(4, 4, 1), 5);
    ASSERT_LE(std::abs(there - here), step / std::sqrt(3.0F) + 2e-6);
  }
}

TEST(Worley, DependsOnTheSeed) {
  int equal = 0;
  for (int i = 0; i < 100; ++i) {
    const vec3 p(0.04F * i, 1.3, 2.7);
    equal += worley_noise(p, ivec3(4), 1) == worley_noise(p, ivec3(4), 2) ? 1 : 0;
  }
  EXPECT_EQ(equal, 0);
}

TEST(WorleyFbm, WeighsItsOctavesByTheGain) {
  const vec3 p(0.21, 0.43, 0.77);
  const ivec3 frequency(4, 4, 1);
  const float first = worley_noise(p * vec3(frequency), frequency, 9);
  EXPECT_FLOAT_EQ(worley_fbm(p, frequency, 1, 2, 0.5, 9), first);
  EXPECT_FLOAT_EQ(worley_fbm(p, frequency, 5, 2, 0, 9), first);
  const float two = worley_fbm(p, frequency, 2, 2, 0.5, 9);
  const float second = 3 * two - 2 * first;  // (first + second / 2) / (3 / 2)
  EXPECT_GE(second, 0);
  EXPECT_LE(second, 1);
  EXPECT_NEAR(worley_fbm(p, frequency, 2, 2, 1, 9), (first + second) / 2, 1e-6);
}

TEST(WorleyFbm, TilesAndStaysInRange) {
  Samples samples;
  for (int i = 0; i < 3000; ++i) {
    const vec3 p = vec3(ivec3(samples.in_box(vec3(0), vec3(256)))) / 256.0F;
    const float value = worley_fbm(p, ivec3(4, 4, 1), 4, 2, 0.5, 9);
    ASSERT_GE(value, 0);
    ASSERT_LE(value, 1);
    ASSERT_EQ(value, worley_fbm(p + vec3(1, 0, 0), ivec3(4, 4, 1), 4, 2, 0.5, 9));
    ASSERT_EQ(value, worley_fbm(p + vec3(0, 1, 1), ivec3(4, 4, 1), 4, 2, 0.5, 9));
  }
}

}  // namespace
}  // namespace cloudscape
