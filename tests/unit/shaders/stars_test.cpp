// The seeded stars: as many of each magnitude as there are, each with its light, wherever the pixels lie.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/shaders/glsl.h"
#include "unit/shaders/samples.h"

namespace cloudscape {
namespace {

using glsl::vec3;
constexpr double pi = 3.141592653589793238L;

TEST(CubePlace, GoesThereAndBack) {
  for (int i = 0; i < 500; ++i) {
    const double z = 2 * (i + 0.5) / 500 - 1, azimuth = 2.399963 * i;
    const vec3 d(std::sqrt(1 - z * z) * std::cos(azimuth), std::sqrt(1 - z * z) * std::sin(azimuth), z);
    const vec3 place = glsl::cube_place(d);
    ASSERT_LE(std::max(std::abs(place.x), std::abs(place.y)), 1 + 1e-6);
    const vec3 back = glsl::cube_direction(place);
    EXPECT_LT(glm::length(back - d), 1e-5) << i;
  }
}

// Whole sky counts of the Yale Bright Star Catalogue, brighter than magnitudes 2, 4 and 6: 50, 513, 5080 or so.
TEST(StarIrradiance, HasTheCountsOfTheSky) {
  const int stars = 2 * 6 * 36 * 36;
  for (const auto& [magnitude, expected] : {std::pair{2.0, 50}, {4.0, 513}, {6.0, 5080}}) {
    int brighter = 0;
    for (int i = 0; i < stars; ++i)
      brighter += glsl::star_irradiance((i + 0.5) / stars) > std::pow(10, -0.4L * magnitude);
    EXPECT_NEAR(std::log10(brighter), std::log10(expected), 0.12) << magnitude;
  }
}

// The light of one cell, summed over pixels of any offset, is that of its star.
TEST(StarRadiance, KeepsItsLightAsThePixelsMove) {
  const float sigma = 0.0006, pixel = 0.001;
  const vec3 middle = glsl::cube_direction(vec3((20 + 0.5) / 36 * 2 - 1, (15 + 0.5) / 36 * 2 - 1, 0));
  double first = 0;
  for (int offset = 0; offset < 5; ++offset) {
    double sum = 0;
    for (int y = -30; y <= 30; ++y)
      for (int x = -30; x <= 30; ++x) {
        const vec3 d = glm::normalize(middle + vec3(0, pixel * (x + 0.2F * offset), pixel * (y + 0.13F * offset)));
        if (glm::length(glsl::cube_place(d) - glsl::cube_place(middle)) > 1.0 / 36) continue;
        sum += glsl::star_radiance(d, 0, sigma).y * pixel * pixel;
      }
    if (offset == 0) first = sum;
    EXPECT_GT(sum, 0);
    EXPECT_NEAR(sum / first, 1, 0.03) << offset;
  }
}

}  // namespace
}  // namespace cloudscape
