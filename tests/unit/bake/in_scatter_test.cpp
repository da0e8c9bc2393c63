// The discrete ordinates against published slabs, and against what must hold whatever the cloud.
#include "bake/in_scatter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bake/in_scatter_beam.h"

namespace cloudscape::bake {
namespace {

// Layers of optical depth `depth` in all, between two empty ones, lit by a sun of irradiance 1.
InScatterProblem slab(double depth, double g, double albedo, int layers, double sun_cosine = 1) {
  InScatterProblem problem;
  InScatterGrid& grid = problem.grid;
  grid.size = {4, 4, layers + 2};
  grid.spacing_m = glm::dvec3(100);
  grid.extinction_per_m.assign(16 * static_cast<std::size_t>(layers + 2), static_cast<float>(depth / (layers * 100.0)));
  std::fill_n(grid.extinction_per_m.begin(), 16, 0.0F);
  std::fill_n(grid.extinction_per_m.rbegin(), 16, 0.0F);
  problem.moments = scatter_moments(g);
  problem.single_scattering_albedo = albedo;
  problem.light.sun_direction = {std::sqrt(1 - sun_cosine * sun_cosine), 0, sun_cosine};
  problem.light.sun_irradiance.assign(static_cast<std::size_t>(layers + 2), glm::vec3(1));
  return problem;
}

// Clouds of different thickness, side by side, from a formula.
InScatterProblem broken_clouds() {
  InScatterProblem problem = slab(1, 0.85, 1, 10, 0.6);
  problem.grid.size = {16, 16, 12};
  problem.grid.extinction_per_m.clear();
  for (int z = 0; z < 12; ++z)
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const double wave = std::sin(x * 0.7853981634) * std::cos(y * 0.3926990817) + 0.3;
        const bool cloud = z > 0 && z < 11 && wave > 0.1 * z - 0.4;
        problem.grid.extinction_per_m.push_back(cloud ? 0.02F : 0.0F);
      }
  return problem;
}

struct PublishedSlab {
  double depth, g, albedo, reflected, transmitted;
};

// Van de Hulst 1980, tables 12 and 35; DISORT test 3; and own adding-doubling (notes/physics.md 2.1 and 2.2).
TEST(InScatter, SlabsReflectAndTransmitWhatIsPublished) {
  const PublishedSlab cases[] = {{1, 0, 1, 0.34133, 0.65867},      {2, 0.75, 0.9, 0.09739, 0.66096},
                                 {8, 0.75, 1, 0.506408, 0.493592}, {1, 0.85, 1, 0.042316, 0.957684},
                                 {4, 0.85, 1, 0.190915, 0.809085}, {16, 0.85, 1, 0.557209, 0.442791}};
  for (const PublishedSlab& each : cases) {
    const auto solution = solve_in_scatter(slab(each.depth, each.g, each.albedo, 16), {1e-5, 500});
    ASSERT_TRUE(solution);
    // What two terms of the phase function can do: 0.02 (Joseph and others 1976, table 2).
    EXPECT_NEAR(solution->share_above, each.reflected, 0.02) << each.depth << " " << each.g;
    EXPECT_NEAR(solution->share_below, each.transmitted, 0.02) << each.depth << " " << each.g;
  }
}

TEST(InScatter, WithoutAbsorptionAllLightLeaves) {
  const auto solution = solve_in_scatter(broken_clouds(), {1e-5, 500});
  ASSERT_TRUE(solution);
  EXPECT_NEAR(solution->share_above + solution->share_below, 1, 0.04);
  EXPECT_GT(solution->share_above, 0.1);
}

// A furnace: nothing can be seen of a medium that takes nothing where all around is equally bright.
TEST(InScatter, EvenLightStaysEven) {
  InScatterProblem problem = broken_clouds();
  problem.light.sun_irradiance.assign(12, glm::vec3(0));
  problem.light.surroundings.fill(glm::vec3(0.3F, 0.5F, 0.7F));
  problem.grid.periodic = false;
  const auto solution = solve_in_scatter(problem, {1e-6, 500});
  ASSERT_TRUE(solution);
  for (const Moments& light : solution->light) {
    EXPECT_NEAR(light.even[0] / 0.3, light.even[2] / 0.7, 1e-4);
    EXPECT_NEAR(light.even[1], 0.5, 0.05);  // sources between points count as straight lines: up to 9 % is lost here
  }
}

TEST(InScatter, IsBrighterOnTheSideOfTheSun) {
  const auto solution = solve_in_scatter(slab(16, 0.85, 1, 16));
  ASSERT_TRUE(solution);
  const auto layer = [&](int z) { return solution->light[16 * static_cast<std::size_t>(z)].even[0]; };
  EXPECT_GT(layer(14), 2 * layer(2));
  EXPECT_GT(solution->light[16 * 8].up[0], 0) << "light goes down: it comes from above";
  EXPECT_NEAR(solution->light[16 * 8].east[0], 0, 1e-4);
}

// The coarse grid is where the iteration begins, and not where it ends.
TEST(InScatter, DoesNotDependOnWhereItBegins) {
  const auto rough = solve_in_scatter(broken_clouds(), {1e-4, 1000}),
             exact = solve_in_scatter(broken_clouds(), {1e-7, 1000});
  ASSERT_TRUE(rough && exact);
  EXPECT_LT(rough->iterations, exact->iterations);
  for (std::size_t i = 0; i < exact->light.size(); ++i)
    EXPECT_NEAR(rough->light[i].even[0], exact->light[i].even[0], 5e-3 * exact->light[i].even[0] + 1e-6);
}

TEST(InScatter, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(solve_in_scatter(broken_clouds(), {}, stop.get_token()));
}

TEST(InScatterBeam, FallsExponentiallyThroughASlab) {
  const InScatterProblem problem = slab(3, 0, 1, 12, 0.5);
  const std::vector<float> beam = beam_transmittance(problem.grid, problem.light.sun_direction);
  EXPECT_NEAR(beam.back(), 1, 0.02);
  EXPECT_NEAR(std::log(beam[0]), -3 / 0.5, 0.15);
  EXPECT_NEAR(std::log(beam[16 * 6 + 5]), -(3 * 6.5 / 12) / 0.5, 0.15);
}

TEST(ScatterMoments, BackwardScatteringHasNoForwardPeak) {
  EXPECT_DOUBLE_EQ(scatter_moments(0.8).forward_share, 0.64);
  EXPECT_EQ(scatter_moments(-0.3).forward_share, 0);
}

}  // namespace
}  // namespace cloudscape::bake
