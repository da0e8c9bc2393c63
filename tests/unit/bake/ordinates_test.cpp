// The directions of the discrete ordinates, and what makes their iteration fast.
#include "bake/ordinates.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "bake/anderson.h"

namespace cloudscape::bake {
namespace {

TEST(Ordinates, IntegrateTheFirstMomentsExactly) {
  double sum = 0, squares = 0;
  glm::dvec3 first(0);
  for (const Ordinate& each : ordinates()) {
    EXPECT_NEAR(glm::length(each.direction), 1, 1e-5);
    sum += each.weight;
    first += double{each.weight} * glm::dvec3(each.direction);
    squares += double{each.weight} * each.direction.z * each.direction.z;
  }
  EXPECT_NEAR(sum, 1, 1e-6);
  EXPECT_NEAR(glm::length(first), 0, 1e-6);
  EXPECT_NEAR(squares, 1.0 / 3, 1e-5);
}

TEST(Stencil, FindsTheNearestPlaneOfPoints) {
  const Stencil flat = stencil_of({0.8F, -0.6F, 0}, {100, 50, 10});
  EXPECT_EQ(flat.axis, 1);  // 50 / 0.6 is less than 100 / 0.8
  EXPECT_EQ(flat.towards, glm::ivec3(1, -1, 1));
  EXPECT_NEAR(flat.length_m, 50 / 0.6, 1e-3);
  EXPECT_EQ(flat.others, (std::array<int, 2>{0, 2}));
  EXPECT_NEAR(flat.shares[0], 0.8 * 50 / 0.6 / 100, 1e-5);
  EXPECT_NEAR(flat.shares[1], 0, 1e-6);
}

// x = A x + b of two numbers, where the slow one gains 2 % a step: plain iteration takes hundreds.
TEST(Anderson, FindsTheFixedPointOfALinearIterationInAFewSteps) {
  std::vector<Colours> x(2);
  Anderson anderson(3);
  int steps = 0;
  const auto g = [](const std::vector<Colours>& at) {
    const float a = 0.98F * at[0][0] + 0.1F * at[1][0] + 1, b = 0.3F * at[1][0] + 0.5F;
    return std::vector<Colours>{Colours{a, a, a, 0}, Colours{b, b, b, 0}};
  };
  while (std::abs(g(x)[0][0] - x[0][0]) > 1e-3F && steps < 50) x = anderson.next(x, g(x)), ++steps;
  EXPECT_LE(steps, 8);
  EXPECT_NEAR(x[1][0], 0.5 / 0.7, 1e-3);
  EXPECT_NEAR(x[0][0], (0.1 * 0.5 / 0.7 + 1) / 0.02, 0.2);
}

}  // namespace
}  // namespace cloudscape::bake
