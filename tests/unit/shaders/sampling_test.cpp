// What the path tracer draws, against the distributions that it shall have.
#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "glsl.h"
#include "samples.h"

namespace cloudscape {
namespace {

constexpr int draws = 200000;

// Shares of the draws in ten cells of the cosine, against the integral of 2 pi `phase` over each.
void expect_cosines(const std::function<float(float)>& draw, const std::function<double(double)>& phase) {
  std::array<double, 10> counts{};
  Samples samples;
  for (int i = 0; i < draws; ++i) {
    const float cosine = draw(samples.between(0, 1));
    ASSERT_LE(std::abs(cosine), 1.0L);
    ++counts[std::min<std::size_t>(9, static_cast<std::size_t>(5 * (cosine + 1)))];
  }
  for (std::size_t cell = 0; cell < 10; ++cell) {
    const long double low = -1 + 0.2L * cell;
    const double share =
        6.283185307179586L * integral([&](long double mu) { return phase(mu); }, low, low + 0.2L, 4096);
    EXPECT_NEAR(counts[cell] / draws, share, 5 * std::sqrt(share / draws) + 1e-4L) << "cosine from " << double(low);
  }
}

TEST(Sampling, CosinesOfHenyeyGreenstein) {
  for (const float g : {-0.9F, -0.3F, 0.0F, 0.00005F, 0.002F, 0.5F, 0.85F, 0.95F})
    expect_cosines([g](float u) { return glsl::sample_henyey_greenstein(g, u); },
                   [g](double mu) { return glsl::phase_henyey_greenstein(static_cast<float>(mu), g); });
}

TEST(Sampling, CosinesOfRayleigh) {
  expect_cosines([](float u) { return glsl::sample_rayleigh(u); },
                 [](double mu) { return glsl::phase_rayleigh(static_cast<float>(mu)); });
}

TEST(Sampling, OpticalDepthsAreExponential) {
  Samples samples;
  double sum = 0, squares = 0;
  for (int i = 0; i < draws; ++i) {
    const double depth = glsl::sample_optical_depth(samples.between(0, 1));
    sum += depth, squares += depth * depth;
  }
  EXPECT_NEAR(sum / draws, 1, 0.01L);
  EXPECT_NEAR(squares / draws, 2, 0.05L);
  EXPECT_TRUE(std::isfinite(glsl::sample_optical_depth(16777215.0F / 16777216.0F)));
}

TEST(Sampling, DirectionsStandAtTheirAngle) {
  Samples samples;
  for (int i = 0; i < 1000; ++i) {
    const glm::vec3 axis = i == 0 ? glm::vec3(0, 0, -1) : i == 1 ? glm::vec3(0, 0, 1) : samples.direction();
    const float haversine = std::pow(samples.between(0, 1), 4.0F), turn = samples.between(0, 1);
    const glm::vec3 direction = glsl::direction_about(axis, haversine, turn);
    EXPECT_NEAR(glm::length(direction), 1, 1e-6L);
    const float chord = glm::length(direction - axis);
    EXPECT_NEAR(0.25L * chord * chord, haversine, 1e-6L + 1e-4L * haversine);
  }
}

// All around the axis: the mean is along it.
TEST(Sampling, DirectionsTurnAboutTheAxis) {
  Samples samples;
  const glm::vec3 axis = glm::normalize(glm::vec3(0.3F, -0.8F, 0.5F));
  glm::vec3 sum(0);
  for (int i = 0; i < draws; ++i) sum += glsl::direction_about(axis, 0.25F, samples.between(0, 1));
  EXPECT_NEAR(glm::length(sum / float(draws) - 0.5F * axis), 0, 0.01L);
}

TEST(Sampling, CapsAreEvenAndCosinesAreCosines) {
  Samples samples;
  const glm::vec3 axis = glm::normalize(glm::vec3(-0.2F, 0.4F, 0.9F));
  const float chord = 0.3F;
  double within_half = 0, cosines = 0;
  for (int i = 0; i < draws; ++i) {
    const glm::vec3 on_cap = glsl::sample_cap(axis, chord * chord, samples.between(0, 1), samples.between(0, 1));
    const float at = glm::length(on_cap - axis);
    ASSERT_LE(at, chord + 1e-5L);
    if (at * at < 0.5L * chord * chord) ++within_half;  // the area of a cap is pi times its squared chord
    const float cosine = glm::dot(axis, glsl::sample_cosine(axis, samples.between(0, 1), samples.between(0, 1)));
    ASSERT_GE(cosine, -1e-5L);
    cosines += cosine;
  }
  EXPECT_NEAR(within_half / draws, 0.5L, 0.006L);
  EXPECT_NEAR(cosines / draws, 2.0L / 3, 0.003L);
}

TEST(Sampling, PhaseTableHaversinesAreInverse) {
  for (float coordinate = 0.02F; coordinate < 1; coordinate += 0.02F) {
    const float haversine = glsl::phase_table_haversine(coordinate);
    EXPECT_NEAR(glsl::phase_table_coordinate(2 * std::sqrt(haversine), 2 * std::sqrt(1 - haversine)), coordinate,
                2e-4L);  // towards the back 1 - haversine has few digits left
  }
}

}  // namespace
}  // namespace cloudscape
