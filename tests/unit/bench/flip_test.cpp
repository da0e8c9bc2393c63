// FLIP against NVlabs' own formulas, and against what must hold of it.
//
// NVlabs' test pictures and its package could not be had here. So the expected numbers are of an oracle of its own:
// python/flip_api.py of NVlabs/flip (commit 313517b4) written down again with numpy in double precision, with its
// 2-D kernels where ours are separable, run on the pictures below. NVlabs' single precision differs by some 1e-5.
#include <gmock/gmock.h>

#include <cmath>

#include "bench/flip.h"
#include "bench/flip_color.h"
#include "bench/flip_filters.h"
#include "bench/track_times.h"

namespace cloudscape::bench {
namespace {

constexpr ImageSize size_px{48, 32};
constexpr double tolerance = 1e-5;

using Color = glm::dvec3 (*)(double x, double y);

Picture picture_of(Color color, const ImageSize& size = size_px) {
  Picture picture{size, {}};
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) picture.rgb.push_back(color(x, y));
  return picture;
}

Picture uniform(const glm::dvec3& rgb) { return {size_px, std::vector<glm::dvec3>(48 * 32, rgb)}; }

glm::dvec3 gradient(double x, double y) { return {(x + 0.5) / 48, (y + 0.5) / 32, 0.5}; }

// PCG's output function (O'Neill 2014), 0..1.
double random_of(std::uint32_t n) {
  n = n * 747796405U + 2891336453U;
  n = ((n >> ((n >> 28U) + 4U)) ^ n) * 277803737U;
  return ((n >> 22U) ^ n) / 4294967296.0;
}

glm::dvec3 noisy_gradient(double x, double y) {
  glm::dvec3 rgb = gradient(x, y);
  for (int c = 0; c < 3; ++c) {
    const auto index = static_cast<std::uint32_t>(3 * (y * 48 + x) + c);
    rgb[c] = std::clamp(rgb[c] + 0.2 * (random_of(index) - 0.5), 0.0, 1.0);
  }
  return rgb;
}

glm::dvec3 pale_gradient(double x, double y) { return 0.9 * gradient(x, y) + 0.05; }

glm::dvec3 slanted(double x, double y, double at) {
  return x + std::floor(y / 2) >= at ? glm::dvec3(0.9, 0.8, 0.3) : glm::dvec3(0.1, 0.2, 0.5);
}
glm::dvec3 edge(double x, double y) { return slanted(x, y, 20); }
glm::dvec3 shifted_edge(double x, double y) { return slanted(x, y, 22); }

// Highlights 400 times as bright as the rest.
glm::dvec3 highlight(double x, double y) {
  const double v = 0.05 + 20 * std::exp(-(std::pow(x - 30, 2) + std::pow(y - 12, 2)) / 18) + 0.002 * x;
  return {v, 0.9 * v, 0.7 * v + 0.1};
}
glm::dvec3 other_highlight(double x, double y) {
  const double v = 0.06 + 16 * std::exp(-(std::pow(x - 31, 2) + std::pow(y - 12, 2)) / 20) + 0.002 * x;
  return {v, 0.88 * v, 0.75 * v + 0.09};
}

void expect_errors(const std::vector<double>& errors, double mean, const std::array<double, 4>& some) {
  EXPECT_NEAR(mean_of(errors), mean, tolerance);
  constexpr std::array<std::array<int, 2>, 4> places{{{0, 0}, {21, 7}, {24, 16}, {47, 31}}};
  for (std::size_t i = 0; i < places.size(); ++i)
    EXPECT_NEAR(errors[places[i][1] * 48 + places[i][0]], some[i], tolerance)
        << "at " << places[i][0] << ", " << places[i][1];
}

TEST(LdrFlip, OfNoiseAgreesWithNvlabs) {
  expect_errors(ldr_flip(picture_of(gradient), picture_of(noisy_gradient)), 0.1213318,
                {0.036908, 0.059770, 0.134412, 0.325575});
}

TEST(LdrFlip, OfAShiftedEdgeAgreesWithNvlabs) {
  expect_errors(ldr_flip(picture_of(edge), picture_of(shifted_edge)), 0.1556723, {0, 0.493438, 0.012675, 0});
}

TEST(LdrFlip, OfLessContrastAgreesWithNvlabs) {
  expect_errors(ldr_flip(picture_of(gradient), picture_of(pale_gradient)), 0.1859024,
                {0.136503, 0.117658, 0.044483, 0.350158});
}

TEST(HdrFlip, OfHighlightsAgreesWithNvlabs) {
  expect_errors(hdr_flip(picture_of(highlight), picture_of(other_highlight)), 0.2280044,
                {0.243674, 0.303847, 0.473581, 0.093300});
  EXPECT_NEAR(mean_of(hdr_flip(picture_of(other_highlight), picture_of(highlight))), 0.2270750, tolerance);
}

TEST(HdrFlip, TakesItsExposuresFromTheReference) {
  const ExposureRange range = exposure_range(picture_of(highlight));
  EXPECT_NEAR(range.start_ev, -3.106004, tolerance);
  EXPECT_NEAR(range.stop_ev, 4.305607, tolerance);
  EXPECT_EQ(range.count, 8) << "a stop apart, and no more than that";
  EXPECT_EQ(range.exposure_ev(0), range.start_ev);
  EXPECT_DOUBLE_EQ(range.exposure_ev(7), range.stop_ev);
}

// The exposure that brings a luminance to 0.85 through the curve: what Andersson et al. 2021 define it by.
TEST(HdrFlip, ExposesAUniformPictureToTheCurvesShoulder) {
  const ExposureRange range = exposure_range(uniform({3, 3, 3}));
  EXPECT_EQ(range.start_ev, range.stop_ev);
  EXPECT_EQ(range.count, 2);
  const double x = 0.6 * 3 * std::exp2(range.start_ev);  // with the factor that the curve has taken out
  EXPECT_NEAR((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.85, 1e-12);
}

TEST(HdrFlip, DoesNotDependOnTheUnitOfRadiance) {
  Picture reference = picture_of(highlight), test = picture_of(other_highlight);
  const double mean = mean_of(hdr_flip(reference, test));
  for (Picture* picture : {&reference, &test})
    for (glm::dvec3& rgb : picture->rgb) rgb *= 37.0;
  EXPECT_NEAR(mean_of(hdr_flip(reference, test)), mean, 1e-9);
}

TEST(HdrFlip, OfABlackReferenceIsANumber) {
  for (const double error : hdr_flip(uniform({0, 0, 0}), uniform({1, 1, 1}))) EXPECT_GT(error, 0.5);
}

TEST(HdrFlip, EndsWhereLightIsBeyondMeasure) {
  Picture test = picture_of(highlight);
  test.rgb[100] = glm::dvec3(1e300);
  for (const double error : hdr_flip(picture_of(highlight), test)) EXPECT_TRUE(error >= 0 && error <= 1) << error;
}

TEST(LdrFlip, OfTheSamePictureIsZero) {
  for (const double error : ldr_flip(picture_of(noisy_gradient), picture_of(noisy_gradient))) EXPECT_EQ(error, 0);
  for (const double error : hdr_flip(picture_of(highlight), picture_of(highlight))) EXPECT_EQ(error, 0);
}

TEST(LdrFlip, IsSymmetric) {
  const Picture a = picture_of(edge), b = picture_of(noisy_gradient);
  EXPECT_EQ(ldr_flip(a, b), ldr_flip(b, a));
}

// No edges, no points: the colour difference alone. L* from 0 to 100, no chroma: 100^0.7, mapped beyond the knee.
TEST(LdrFlip, OfBlackAndWhiteIsTheirColorDifference) {
  const double most = std::pow(hyab(hunt_lab_from_linear({0, 1, 0}), hunt_lab_from_linear({0, 0, 1})), 0.7);
  const double difference = std::pow(100, 0.7), knee = 0.4 * most;
  const double expected = 0.95 + 0.05 * (difference - knee) / (most - knee);
  EXPECT_NEAR(expected, 0.96738, 1e-5);
  for (const double error : ldr_flip(uniform({0, 0, 0}), uniform({1, 1, 1}))) EXPECT_NEAR(error, expected, 1e-6);
}

TEST(LdrFlip, OfGreenAndBlueIsOne) {
  for (const double error : ldr_flip(uniform({0, 1, 0}), uniform({0, 0, 1}))) EXPECT_NEAR(error, 1, 1e-6);
}

// A pixel more or less blurs away where there are many to a degree, and shows where there are few.
TEST(LdrFlip, SeesLessFromFartherAway) {
  Picture dotted = uniform({0.5, 0.5, 0.5});
  dotted.rgb[16 * 48 + 24] = glm::dvec3(1);
  const Picture plain = uniform({0.5, 0.5, 0.5});
  const auto peak = [&](double pixels_per_degree) { return ldr_flip(plain, dotted, pixels_per_degree)[16 * 48 + 24]; };
  EXPECT_LT(peak(67), 0.7 * peak(20));
}

// Lindbloom's L*a*b* of sRGB's primaries (D65): green 87.73, -86.18, 83.18; blue 32.30, 79.19, -107.86.
TEST(FlipColor, LabOfThePrimaries) {
  const glm::dvec3 green = hunt_lab_from_linear({0, 1, 0}), blue = hunt_lab_from_linear({0, 0, 1});
  EXPECT_NEAR(green.x, 87.73, 0.02);
  EXPECT_NEAR(green.y / (0.01 * green.x), -86.18, 0.02);
  EXPECT_NEAR(green.z / (0.01 * green.x), 83.18, 0.02);
  EXPECT_NEAR(blue.x, 32.30, 0.02);
  EXPECT_NEAR(blue.y / (0.01 * blue.x), 79.19, 0.02);
  EXPECT_NEAR(blue.z / (0.01 * blue.x), -107.86, 0.02);
}

TEST(FlipColor, GoesThereAndBack) {
  const glm::dvec3 srgb(0.02, 0.4, 0.9);
  const glm::dvec3 back = srgb_from_linear(linear_from_opponent(opponent_from_linear(linear_from_srgb(srgb))));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(back[c], srgb[c], 1e-12);
}

TEST(FlipFilters, KeepAUniformPicture) {
  constexpr SensitivityLobe lobes[] = {{34.1, 0.04}, {13.5, 0.025}};
  for (const double value : blurred(Plane(48 * 32, 0.7), size_px, lobes, 67)) EXPECT_NEAR(value, 0.7, 1e-12);
}

TEST(FlipFilters, FeatureKernelsAreBalanced) {
  const FeatureKernels kernels = feature_kernels(67);
  const auto sum = [](const Kernel& kernel, double sign) {
    double total = 0;
    for (const double weight : kernel) total += weight * sign > 0 ? weight : 0;
    return total;
  };
  EXPECT_NEAR(sum(kernels.gaussian, 1), 1, 1e-12);
  for (const Kernel* kernel : {&kernels.slope, &kernels.curvature}) {
    EXPECT_NEAR(sum(*kernel, 1), 1, 1e-12);
    EXPECT_NEAR(sum(*kernel, -1), -1, 1e-12);
  }
}

}  // namespace
}  // namespace cloudscape::bench
