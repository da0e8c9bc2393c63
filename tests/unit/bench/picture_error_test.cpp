// Errors of pictures in numbers, and pictures as they are displayed.
#include <gmock/gmock.h>

#include <cmath>

#include "bench/picture_error.h"

namespace cloudscape::bench {
namespace {

Picture row_of(const std::vector<glm::dvec3>& rgb) { return {{static_cast<int>(rgb.size()), 1}, rgb}; }

TEST(RadianceError, AddsUpChannelsOfEachPixel) {
  const Picture reference = row_of({{1, 2, 1}, {0.1, 0.1, 0.2}});
  const Picture test = row_of({{1.5, 1.5, 1}, {0.1, 0.1, 0.2}});
  const RadianceError error = radiance_error(reference, test, {true, true});
  EXPECT_EQ(error.pixels, 2);
  EXPECT_DOUBLE_EQ(error.mean, (1.0 / 4 + 0) / 2);
  EXPECT_DOUBLE_EQ(error.p95, 0.25);
  const double lost = 0.7152 * 0.5 - 0.2126 * 0.5, all = luminance({1, 2, 1}) + luminance({0.1, 0.1, 0.2});
  EXPECT_NEAR(error.log_ratio, std::log((all - lost) / all), 1e-12);
}

TEST(RadianceError, CountsOnlyWhatIsAskedAndLit) {
  const Picture reference = row_of({{1, 1, 1}, {1, 1, 1}, {0, 0, 0}}), test = row_of({{2, 2, 2}, {9, 9, 9}, {1, 1, 1}});
  const RadianceError error = radiance_error(reference, test, {true, false, true});
  EXPECT_EQ(error.pixels, 1);
  EXPECT_DOUBLE_EQ(error.mean, 1);
  EXPECT_NEAR(error.log_ratio, std::log(2), 1e-12);
  EXPECT_EQ(radiance_error(reference, test, {false, false, false}).pixels, 0);
}

TEST(RelativeNoise, IsTheErrorOverTheRadiance) {
  Frame frame;
  frame.request.size_px = {2, 1};
  frame.radiance_rgba = {1, 2, 1, 1, 5, 5, 5, 0};
  frame.standard_error_rgb = {0.1F, 0.2F, 0.1F, 5, 5, 5};
  EXPECT_NEAR(relative_noise(frame, {true, false}), 0.1, 1e-6);
  EXPECT_NEAR(relative_noise(frame, {true, true}), 0.55, 1e-6);
}

TEST(Psnr, OfAKnownDifference) {
  EXPECT_NEAR(psnr_db(row_of({{0.5, 0.5, 0.5}}), row_of({{0.6, 0.4, 0.6}})), 20, 1e-9);
  EXPECT_EQ(psnr_db(row_of({{0.5, 0.5, 0.5}}), row_of({{0.5, 0.5, 0.5}})), 100);
}

TEST(Tiles, AreMeansOfWholeSquares) {
  Picture picture{{5, 3}, {}};
  for (int i = 0; i < 15; ++i) picture.rgb.emplace_back(i);
  const Picture tiles = tiles_of(picture, 2);
  EXPECT_EQ(tiles.size_px, (ImageSize{2, 1}));
  EXPECT_EQ(tiles.rgb[0], glm::dvec3((0 + 1 + 5 + 6) / 4.0));
  EXPECT_EQ(tiles.rgb[1], glm::dvec3((2 + 3 + 7 + 8) / 4.0));
}

TEST(DisplayPicture, ExposesEncodesAndRounds) {
  Display display;
  display.tone_curve = ToneCurve::none;
  display.exposure_ev = 1;
  const Picture shown = display_picture(row_of({{0.1, 0.5, 3}}), display);
  EXPECT_DOUBLE_EQ(shown.rgb[0].x, std::round(255 * (1.055 * std::pow(0.2, 1 / 2.4) - 0.055)) / 255);
  EXPECT_DOUBLE_EQ(shown.rgb[0].y, 1);
  EXPECT_DOUBLE_EQ(shown.rgb[0].z, 1);
}

TEST(DisplayPicture, GoesThroughTheTonesCurve) {
  Display display;
  display.exposure_ev = 0;
  display.tone_curve = ToneCurve::reinhard;  // L / (1 + L)
  EXPECT_DOUBLE_EQ(display_picture(row_of({{1, 1, 1}}), display).rgb[0].x, 188.0 / 255);
  display.tone_curve = ToneCurve::aces;
  EXPECT_LT(display_picture(row_of({{1, 1, 1}}), display).rgb[0].x, 1);
}

}  // namespace
}  // namespace cloudscape::bench
