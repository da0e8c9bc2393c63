// The horizon of each point against one that looks at every point of the line towards the azimuth.
#include "bake/terrain_horizon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace cloudscape::bake {
namespace {

constexpr int side = 64;
constexpr double spacing_m = 200, planet_m = 6360000;

std::vector<float> hills() {
  std::mt19937 random(7);
  std::vector<float> heights(side * side);
  for (int i = 0; i < side * side; ++i) {
    const double x = 0.1 * (i % side), y = 0.1 * static_cast<int>(i / side);
    heights[static_cast<std::size_t>(i)] =
        static_cast<float>(400 * (1 + std::sin(2 * x) * std::cos(y)) + 0.02 * static_cast<double>(random() % 1000));
  }
  return heights;
}

class Horizons : public testing::TestWithParam<double> {  // azimuth, degrees east of north
 protected:
  Horizons() {
    const double azimuth = GetParam() * 3.14159265358979 / 180;
    problem.towards = {std::sin(azimuth), std::cos(azimuth)};
  }
  // Of the bilinear surface; nullopt beyond a map that does not tile.
  std::optional<double> height_m(double x, double y) const {
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    if (!problem.tiling && (x < 0 || y < 0 || x > side - 1 || y > side - 1)) return std::nullopt;
    const auto at = [&](int i, int j) {
      return double{heights[static_cast<std::size_t>(((j % side + side) % side) * side + (i % side + side) % side)]};
    };
    return std::lerp(std::lerp(at(column, row), at(column + 1, row), x - column),
                     std::lerp(at(column, row + 1), at(column + 1, row + 1), x - column), y - row);
  }
  double expected(int x, int y) const {
    double tangent = -0.2;
    const double from_m = std::max(*height_m(x, y), problem.water_m);
    for (double s = 1; s * spacing_m < 300000; s += 0.125) {
      const auto met_m = height_m(x + s * problem.towards.x, y + s * problem.towards.y);
      if (!met_m) break;
      tangent = std::max(tangent, (*met_m - from_m) / (s * spacing_m) - s * spacing_m / (2 * planet_m));
    }
    return tangent;
  }
  std::vector<float> heights = hills();
  HorizonProblem problem{heights, side, spacing_m};
};

// The lines lie up to half a spacing beside a point: its horizon is that of its neighbourhood.
TEST_P(Horizons, AreThoseOfEveryPoint) {
  for (const bool tiling : {true, false})
    for (const double water_m : {-1e9, 500.0}) {
      problem.tiling = tiling, problem.water_m = water_m;
      const std::vector<float> tangents = horizon_tangents(problem);
      ASSERT_EQ(tangents.size(), heights.size());
      double sum = 0, worst = 0;
      int count = 0;
      for (int y = 3; y < side - 3; y += 3)
        for (int x = 3; x < side - 3; x += 3, ++count) {
          const double difference = std::abs(double{tangents[static_cast<std::size_t>(y * side + x)]} - expected(x, y));
          sum += difference, worst = std::max(worst, difference);
        }
      EXPECT_LT(sum / count, 0.0055) << tiling << " " << water_m << ": of slopes of 0.3";
      EXPECT_LT(worst, 0.06) << tiling << " " << water_m;
    }
}

INSTANTIATE_TEST_SUITE_P(AllAround, Horizons, testing::Values(0, 17, 45, 90, 133, 180, 225, 260, 333));

// Along an axis the lines go through the points: nothing is in between.
TEST(HorizonsAlongAnAxis, AreExact) {
  std::vector<float> heights(side * side, 0.0F);
  for (int y = 0; y < side; ++y) heights[static_cast<std::size_t>(y * side + 40)] = 1000;
  const std::vector<float> tangents = horizon_tangents({heights, side, spacing_m, false, -1e9, {1, 0}});
  for (int x = 0; x < 40; ++x) {
    const double s = spacing_m * (40 - x);
    EXPECT_NEAR(tangents[static_cast<std::size_t>(10 * side + x)], 1000 / s - s / (2 * planet_m), 1e-6) << x;
  }
  EXPECT_FLOAT_EQ(tangents[10 * side + 63], -0.2F) << "there is nothing east of it";
}

TEST(HorizonsAlongAnAxis, StopWhenAsked) {
  const std::vector<float> heights(side * side, 0.0F);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(horizon_tangents({heights, side}, stop.get_token()).empty());
}

}  // namespace
}  // namespace cloudscape::bake
