// The rays of the four lenses: geometry that each one promises.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/shaders/glsl.h"
#include "unit/shaders/samples.h"

namespace cloudscape {
namespace {

using glsl::LensRay, glsl::vec2, glsl::vec3;
enum Kind { perspective, orthographic, panorama, fisheye };  // as core's LensKind

const vec2 size_px(320, 180);
constexpr double pi = 3.141592653589793238L;

vec3 direction(int kind, vec2 pixel, float half_height = 1) {
  return glsl::lens_ray(kind, pixel, size_px, half_height, 1000).direction;
}
double angle_between(vec3 a, vec3 b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }
const vec3 forward(0, 0, 1);

TEST(Lens, RaysHaveUnitLength) {
  Samples samples;
  for (const int kind : {perspective, orthographic, panorama, fisheye})
    for (int i = 0; i < 2000; ++i) {
      const vec2 pixel(samples.between(0, 320), samples.between(0, 180));
      ASSERT_NEAR(glm::length(direction(kind, pixel)), 1, 1e-6);
    }
}

TEST(Lens, LooksForwardInTheMiddleAndUpAtTheTop) {
  for (const int kind : {perspective, orthographic, panorama, fisheye})
    EXPECT_NEAR(angle_between(direction(kind, size_px / 2.0F), forward), 0, 1e-6);
  for (const int kind : {perspective, panorama, fisheye}) {
    EXPECT_GT(direction(kind, vec2(160, 10)).y, 0.1);
    EXPECT_GT(direction(kind, vec2(200, 90)).x, 0.1);
  }
}

TEST(Perspective, EdgesStandAtTheFieldOfView) {
  for (const double fov_deg : {20.0, 50.0, 110.0}) {
    const double half = fov_deg * pi / 360;
    const float half_height = std::tan(half);
    EXPECT_NEAR(angle_between(direction(perspective, vec2(160, 0), half_height), forward), half, 1e-6);
    EXPECT_NEAR(angle_between(direction(perspective, vec2(160, 180), half_height), forward), half, 1e-6);
    const double half_width = std::atan(std::tan(half) * 320 / 180);
    EXPECT_NEAR(angle_between(direction(perspective, vec2(320, 90), half_height), forward), half_width, 1e-6);
  }
}

// Square pixels: the picture plane is met at evenly spaced points, the same to the right as up.
TEST(Perspective, KeepsStraightLinesAndSquarePixels) {
  const auto on_plane = [](float x, float y) {
    const vec3 d = direction(perspective, vec2(x, y), 0.5);
    return vec2(d.x / d.z, d.y / d.z);
  };
  const float pixel = 2 * 0.5F / 180;
  for (int i = 0; i < 90; i += 7) {
    EXPECT_NEAR(on_plane(160 + i, 90).x, i * pixel, 1e-6);
    EXPECT_NEAR(on_plane(160, 90 - i).y, i * pixel, 1e-6);
    EXPECT_NEAR(on_plane(13, 90 - i).y, i * pixel, 1e-6);
  }
}

TEST(Orthographic, RaysAreParallelAndSpanTheWidth) {
  const auto ray = [](float x, float y) { return glsl::lens_ray(orthographic, vec2(x, y), size_px, 1, 1000); };
  for (const vec2 pixel : {vec2(0, 0), vec2(320, 180), vec2(17, 151)})
    EXPECT_EQ(ray(pixel.x, pixel.y).direction, forward);
  EXPECT_NEAR(ray(320, 90).origin.x - ray(0, 90).origin.x, 1000, 1e-3);
  EXPECT_NEAR(ray(160, 0).origin.y - ray(160, 180).origin.y, 1000.0L * 180 / 320, 1e-3);
}

// Solid angle of a triangle of directions (Van Oosterom and Strackee 1983).
double triangle(vec3 a, vec3 b, vec3 c) {
  const double volume = glm::dot(a, glm::cross(b, c));
  return 2 * std::atan2(std::abs(volume), 1 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
}
double pixel_solid_angle(int kind, int x, int y) {
  const vec3 a = direction(kind, vec2(x, y)), b = direction(kind, vec2(x + 1, y));
  const vec3 c = direction(kind, vec2(x, y + 1)), d = direction(kind, vec2(x + 1, y + 1));
  return triangle(a, b, d) + triangle(a, d, c);
}

TEST(Panorama, CoversTheWholeSphereOnce) {
  double sum = 0;
  for (int y = 0; y < 180; ++y)
    for (int x = 0; x < 320; ++x) sum += pixel_solid_angle(panorama, x, y);
  EXPECT_NEAR(sum / (4 * pi), 1, 1e-3);
}

TEST(Panorama, IsLinearInAzimuthAndElevation) {
  for (const auto& [x, azimuth] : {std::pair{0.0, -pi}, {80.0, -pi / 2}, {240.0, pi / 2}}) {
    const vec3 d = direction(panorama, vec2(x, 90));
    EXPECT_NEAR(d.x, std::sin(azimuth), 1e-6);
    EXPECT_NEAR(d.z, std::cos(azimuth), 1e-6);
  }
  for (const double y : {0.0, 45.0, 120.0, 180.0})
    EXPECT_NEAR(direction(panorama, vec2(40, y)).y, std::sin(pi / 2 * (1 - y / 90)), 1e-6);
}

TEST(Fisheye, AngleGrowsWithTheRadius) {
  for (double share = 0.125; share <= 1; share += 0.125)
    for (int i = 0; i < 8; ++i) {
      const double azimuth = pi * i / 4;
      const vec2 pixel(160 + 90 * share * std::cos(azimuth), 90 - 90 * share * std::sin(azimuth));
      const vec3 d = direction(fisheye, pixel);
      EXPECT_NEAR(angle_between(d, forward), share * pi / 2, 2e-6);
      EXPECT_NEAR(std::cos(std::atan2(d.y, d.x) - azimuth), 1, 1e-6);
    }
}

TEST(Fisheye, CoversAHemisphereInsideItsCircleAlone) {
  double sum = 0;
  for (int y = 0; y < 180; ++y)
    for (int x = 0; x < 320; ++x)
      if (glsl::lens_ray(fisheye, vec2(x, y) + 0.5F, size_px, 1, 1).valid > 0) sum += pixel_solid_angle(fisheye, x, y);
  EXPECT_NEAR(sum / (2 * pi), 1, 0.01);  // the circle's rim is stepped
  EXPECT_EQ(glsl::lens_ray(fisheye, vec2(1, 1), size_px, 1, 1).valid, 0);
}

}  // namespace
}  // namespace cloudscape
