// The march's step and the thesis' in-scattered light against their closed forms.
#include <gtest/gtest.h>

#include <algorithm>

#include "unit/shaders/glsl.h"
#include "unit/shaders/samples.h"

namespace cloudscape {
namespace {

using glsl::beer_powder, glsl::integrate_segment, glsl::olajos_light;

TEST(Segment, MeetsTheClosedForm) {
  for (const float extinction : {1e-7F, 1e-4F, 0.04F, 0.3F, 10.0F})
    for (const float length : {0.1F, 10.0F, 24.9F, 25.1F, 500.0F, 9999.0F}) {
      const long double depth = static_cast<long double>(extinction) * length;
      const glsl::vec2 segment = integrate_segment(extinction, length);
      const double path = -std::expm1(-depth) / extinction;
      // 1 - exp(-depth) loses digits as depth falls to 1e-3, where the series takes over.
      EXPECT_NEAR(segment.x / path, 1, 1e-4) << extinction << ' ' << length;
      EXPECT_NEAR(segment.y, std::exp(-depth), 1e-6);
    }
}

// What is scattered out of the beam, or absorbed, is what does not pass.
TEST(Segment, KeepsEnergy) {
  Samples samples;
  for (int i = 0; i < 2000; ++i) {
    const float extinction = std::exp(samples.between(-12, 2)), length = std::exp(samples.between(-2, 8));
    const glsl::vec2 segment = integrate_segment(extinction, length);
    ASSERT_NEAR(segment.x * extinction + segment.y, 1, 2e-7) << extinction << ' ' << length;
  }
}

// The march's rule, radiance += T * source * path, T *= transmittance, gives the same in one step or in many.
TEST(Segment, ManyShortOnesEqualOneLong) {
  for (const int count : {2, 16, 100}) {
    double path = 0, transmittance = 1;
    for (int i = 0; i < count; ++i) {
      const glsl::vec2 segment = integrate_segment(0.04, 250.0F / count);
      path += transmittance * segment.x;
      transmittance *= segment.y;
    }
    const glsl::vec2 whole = integrate_segment(0.04, 250);
    EXPECT_NEAR(path / whole.x, 1, 1e-5) << count;
    EXPECT_NEAR(transmittance / whole.y, 1, 1e-5) << count;
  }
}

TEST(Segment, IsItsLengthInClearAir) {
  EXPECT_EQ(integrate_segment(0, 123.5), glsl::vec2(123.5, 1));
  EXPECT_EQ(integrate_segment(0.04, 0), glsl::vec2(0, 1));
}

// d/dx exp(-m x) (1 - exp(-c x)) = 0 at x = ln(1 + c/m) / c.
TEST(OlajosLight, IsGreatestWhereItsDerivativeVanishes) {
  struct {
    float m, c;
  } const cases[] = {{0.25, 2}, {1, 1}, {0.1, 20}, {3, 0.5}};
  for (const auto [m, c] : cases) {
    const double at = std::log1p(static_cast<double>(c) / m) / c;
    const auto light = [m = m, c = c](double d) { return olajos_light(d, m, c); };
    EXPECT_NEAR(light(at), c / (m + c) * std::pow(m / (m + c), m / c), 1e-6);
    EXPECT_NEAR(greatest(light, 0, 10 * at, 5000), light(at), 1e-6);
    EXPECT_LT(light(0.9 * at), light(at));
    EXPECT_LT(light(1.1 * at), light(at));
  }
}

TEST(OlajosLight, VanishesAtTheSurfaceAndDeepInside) {
  EXPECT_EQ(olajos_light(0, 0.25, 2), 0);
  EXPECT_LT(olajos_light(60, 0.25, 2), 1e-6);
  EXPECT_FLOAT_EQ(olajos_light(0.7, 0, 2), 1 - std::exp(-1.4F));
}

}  // namespace
TEST(BeerPowder, IsBrightestBehindSomeCloudAndAtMostAsBrightAsTheLightThatComes) {
  // 2 x (1 - x^2) with x = exp(-d): greatest at x = 1 / sqrt(3), where it is 4 / (3 sqrt(3)).
  EXPECT_NEAR(beer_powder(0.5F * std::log(3.0F)), 0.769800, 1e-6);
  EXPECT_EQ(beer_powder(0), 0);
  EXPECT_LT(beer_powder(30), 1e-6);
}

}  // namespace cloudscape
