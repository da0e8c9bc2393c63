// Height distribution and towers (Olajos 2.3).
#include <gtest/gtest.h>

#include "unit/shaders/glsl.h"
#include "unit/shaders/samples.h"

namespace cloudscape {
namespace {

using glsl::height_distribution, glsl::tower_offset, glsl::vec2;

// HD'(h) = 0 at h = ln(1 + a/b) / a, where HD = a / (a + b) (b / (a + b))^(b/a).
TEST(HeightDistribution, IsGreatestWhereItsDerivativeVanishes) {
  struct {
    float a, b;
  } const cases[] = {{50, 4}, {10, 2}, {5, 8}, {1000, 0.5}};
  for (const auto [a, b] : cases) {
    const auto hd = [a = a, b = b](double h) { return height_distribution(h, a, b); };
    const double at = std::log1p(static_cast<double>(a) / b) / a;
    EXPECT_NEAR(hd(at), a / (a + b) * std::pow(b / (a + b), b / a), 1e-6);
    EXPECT_NEAR(greatest(hd, 0, 1, 20000), hd(at), 1e-5);
    EXPECT_LT(hd(0.8 * at), hd(at));
    EXPECT_LT(hd(1.25 * at), hd(at));
  }
}

TEST(HeightDistribution, HasItsLimits) {
  EXPECT_EQ(height_distribution(0, 50, 4), 0);
  EXPECT_FLOAT_EQ(height_distribution(0.3, 1000, 4), std::exp(-1.2F));   // an abrupt base
  EXPECT_FLOAT_EQ(height_distribution(0.3, 5, 0), 1 - std::exp(-1.5F));  // no thinning upwards
}

const vec2 center(0.4, 0.55);
float tower_at(vec2 tile, float h) { return tower_offset(tile, h, center, 0.08, 0.9, 0.5); }

TEST(Tower, VanishesAtTheEdgesOfTheTile) {
  for (int i = 0; i <= 16; ++i)
    for (const float h : {0.01F, 0.1F, 0.5F}) {
      const float along = i / 16.0F;
      for (const vec2 edge : {vec2(0, along), vec2(1, along), vec2(along, 0), vec2(along, 1)})
        EXPECT_EQ(tower_offset(edge, h, vec2(0.02, 0.98), 0.5, 1, 2), 0);
    }
}

TEST(Tower, IsGreatestOnItsAxis) {
  for (const float h : {0.05F, 0.3F, 0.6F}) {
    for (int i = 0; i < 1000; ++i) {
      const vec2 tile(i % 32 / 31.0F, i / 32 / 31.0F);
      EXPECT_LE(tower_at(tile, h), tower_at(center, h));
    }
    EXPECT_NEAR(tower_at(center, h), 0.5 * (1 - std::exp(-50 * h)), 1e-6);  // all of its strength, over a flat base
  }
  EXPECT_EQ(tower_at(center, 0), 0);
}

// Its surface is the bell top exp(-d^2 / (2 r^2)): something just below it, nothing above.
TEST(Tower, HasTheSurfaceOfABell) {
  for (const float d : {0.0F, 0.05F, 0.1F, 0.15F}) {
    const float surface = 0.9F * std::exp(-d * d / (2 * 0.08F * 0.08F));
    const vec2 tile = center + vec2(d, 0);
    EXPECT_GT(tower_at(tile, surface - 0.01F), 0) << d;
    EXPECT_EQ(tower_at(tile, surface + 1e-4F), 0) << d;
    EXPECT_EQ(tower_at(tile, surface + 0.2F), 0) << d;
  }
}

TEST(Tower, FallsEvenlyWithDistance) {
  float before = tower_at(center, 0.2);
  for (int i = 1; i < 30; ++i) {
    const float here = tower_at(center + vec2(0, 0.01F * i), 0.2);
    EXPECT_LE(here, before);
    EXPECT_NEAR(here, tower_at(center - vec2(0, 0.01F * i), 0.2), 1e-5);
    before = here;
  }
}

TEST(TileWindow, LeavesTheMiddleAlone) {
  EXPECT_EQ(glsl::tile_window(vec2(0.5)), 1);
  EXPECT_EQ(glsl::tile_window(vec2(0.1, 0.9)), 1);
  EXPECT_EQ(glsl::tile_window(vec2(0.5, 1)), 0);
}

TEST(Stretch, SpreadsAndClamps) {
  EXPECT_FLOAT_EQ(glsl::stretch(0.5, 0.25, 0.75), 0.5);
  EXPECT_EQ(glsl::stretch(0.25, 0.25, 0.75), 0);
  EXPECT_EQ(glsl::stretch(0.2, 0.25, 0.75), 0);
  EXPECT_EQ(glsl::stretch(0.8, 0.25, 0.75), 1);
}

}  // namespace
}  // namespace cloudscape
