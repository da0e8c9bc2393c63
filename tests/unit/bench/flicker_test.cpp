// Flicker against sequences of which it is known.
#include "bench/flicker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cloudscape::bench {
namespace {

constexpr ImageSize size{40, 25};

Picture grey(double value) {
  return {size, std::vector<glm::dvec3>(std::size_t(size.width) * size.height, glm::dvec3(value))};
}

// Normal noise of so much of white on every pixel, new for every picture.
Picture with_noise(Picture picture, double sigma, std::mt19937& random) {
  std::normal_distribution<double> normal(0, sigma);
  for (glm::dvec3& rgb : picture.rgb) rgb += glm::dvec3(normal(random));
  return picture;
}

FlickerFigure flicker_of(int frames, auto&& shown) {
  Flicker flicker;
  for (int t = 0; t < frames; ++t) flicker.add(shown(t));
  return flicker.figure();
}

TEST(Flicker, IsNothingInWhatStandsStillOrDriftsSteadily) {
  EXPECT_EQ(flicker_of(60, [](int) { return grey(0.3); }).mean_percent, 0);
  EXPECT_NEAR(flicker_of(60, [](int t) { return grey(0.1 + 0.01 * t); }).p99_percent, 0, 1e-9);
}

TEST(Flicker, IsTheStandardDeviationOfNoise) {
  std::mt19937 random(7);
  const FlickerFigure figure = flicker_of(400, [&](int) { return with_noise(grey(0.5), 0.02, random); });
  EXPECT_NEAR(figure.mean_percent, 2, 0.05);
  EXPECT_GT(figure.p99_percent, 2);
  EXPECT_LT(figure.p99_percent, 2.6) << "every pixel flickers alike";
  EXPECT_EQ(figure.frames, 400);
}

// A frequency f of amplitude a has the root mean square a / sqrt(2) (1 - cos 2 pi f / fps) / sqrt(3 / 2).
TEST(Flicker, WeighsFrequenciesAsItSays) {
  constexpr double pi = 3.14159265358979323846;
  for (const double cycles_per_frame : {1.0 / 30, 1.0 / 6, 1.0 / 3}) {
    const FlickerFigure figure =
        flicker_of(602, [&](int t) { return grey(0.5 + 0.1 * std::sin(2 * pi * cycles_per_frame * t)); });
    const double expected = 10 / std::sqrt(2.0) * (1 - std::cos(2 * pi * cycles_per_frame)) / std::sqrt(1.5);
    EXPECT_NEAR(figure.mean_percent, expected, 0.01 * expected) << cycles_per_frame;
  }
}

TEST(Flicker, LeavesOutWhatTheTruthDoes) {
  std::mt19937 random(3), same(3);
  Flicker true_to_it, off;
  for (int t = 0; t < 60; ++t) {
    const Picture truth = with_noise(grey(0.5), 0.1, random);
    true_to_it.add(truth, truth);
    off.add(with_noise(truth, t % 2 ? 0.0 : 1e-12, same), grey(0.5));
  }
  EXPECT_EQ(true_to_it.figure().mean_percent, 0);
  EXPECT_NEAR(off.figure().mean_percent, 10, 0.3);
}

TEST(Flicker, TellsOfFewPixelsInThePercentile) {
  const FlickerFigure figure = flicker_of(62, [](int t) {
    Picture picture = grey(0.5);
    for (int i = 0; i < 20; ++i) picture.rgb[i] += t % 2 ? 0.1 : -0.1;  // 2 % of the pixels
    return picture;
  });
  EXPECT_NEAR(figure.p99_percent, 20 / std::sqrt(1.5), 1e-6) << "twice the amplitude: the highest frequency";
  EXPECT_NEAR(figure.mean_percent, 0.02 * figure.p99_percent, 1e-6);
}

TEST(Flicker, IsUnknownOfFewerThanThreeFrames) {
  const FlickerFigure figure = flicker_of(2, [](int t) { return grey(t); });
  EXPECT_EQ(figure.mean_percent, 0);
  EXPECT_EQ(figure.frames, 2);
}

}  // namespace
}  // namespace cloudscape::bench
