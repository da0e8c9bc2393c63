// Cameras: where the sun's disc, or a small ball, appears in the picture of each lens.
#include <glm/geometric.hpp>

#include "fixture.h"
#include "render/block_values.h"

namespace cloudscape::render {
namespace {

constexpr ImageSize size_px{80, 60};

struct Pixel {
  double x, y;
};

// Mean position of what is bright, in pixels from the upper left corner.
Pixel bright_spot(const Frame& frame, std::size_t channel) {
  double sum = 0, x = 0, y = 0;
  const int width = frame.request.size_px.width, height = frame.request.size_px.height;
  for (int i = 0; i < width * height; ++i) {
    const double value = frame.radiance_rgba[4 * static_cast<std::size_t>(i) + channel];
    sum += value, x += value * (i % width + 0.5), y += value * (i / width + 0.5);
  }
  return sum > 0 ? Pixel{x / sum, y / sum} : Pixel{-1, -1};
}

// East, north, up.
glm::dvec3 towards(double azimuth_deg, double elevation_deg) {
  const double a = radians(azimuth_deg), e = radians(elevation_deg);
  return {std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e)};
}

class Lenses : public RenderTest {
 protected:
  static Pixel sun_at(const Lens& lens, const CameraPose& pose, double azimuth_deg, double elevation_deg) {
    Cloudscape sky = empty_world();
    sky.sun.disc = true;
    sky.sun.angular_radius_deg = 3;
    sky.sun.azimuth_deg = azimuth_deg, sky.sun.elevation_deg = elevation_deg;
    FrameRequest request = picture(sky, pose, size_px);
    request.lens = lens;
    return bright_spot(render(request), 0);
  }
};

void expect_pixel(const Pixel& found, double x, double y, double tolerance_px, const std::string& what) {
  EXPECT_NEAR(found.x, x, tolerance_px) << what;
  EXPECT_NEAR(found.y, y, tolerance_px) << what;
}

TEST_F(Lenses, PerspectiveProjectsByTheTangent) {
  const Lens lens{LensKind::perspective, 60, 1};
  const double pixels_per_tangent = 30 / std::tan(radians(30));
  const CameraPose level{camera_m, 40, 0, 0};
  expect_pixel(sun_at(lens, level, 40, 0), 40, 30, 0.3, "straight on");
  expect_pixel(sun_at(lens, level, 60, 0), 40 + pixels_per_tangent * std::tan(radians(20)), 30, 0.4, "to the right");
  expect_pixel(sun_at(lens, level, 40, 15), 40, 30 - pixels_per_tangent * std::tan(radians(15)), 0.4, "above");
}

TEST_F(Lenses, APoseTurnsTheWorldRigidly) {
  const CameraPose pose{camera_m, 250, 35, 25};
  const glm::dvec3 forward = towards(250, 35), level_right = towards(340, 0), level_up = towards(250, 125);
  const double roll = radians(25);
  const glm::dvec3 right = std::cos(roll) * level_right - std::sin(roll) * level_up;  // clockwise: right goes down
  const glm::dvec3 up = std::sin(roll) * level_right + std::cos(roll) * level_up;
  const glm::dvec3 sun = towards(262, 47);
  const double scale = 30 / std::tan(radians(30)) / glm::dot(sun, forward);
  expect_pixel(sun_at({LensKind::perspective, 60, 1}, pose, 262, 47), 40 + scale * glm::dot(sun, right),
               30 - scale * glm::dot(sun, up), 0.4, "rolled");
}

TEST_F(Lenses, ARollToTheRightTurnsThePictureToTheLeft) {
  const Pixel upright = sun_at({LensKind::perspective, 60, 1}, {camera_m, 0, 0, 0}, 0, 15);
  const Pixel rolled = sun_at({LensKind::perspective, 60, 1}, {camera_m, 0, 0, 90}, 0, 15);
  EXPECT_LT(upright.y, 25);
  expect_pixel(rolled, 40 - (30 - upright.y), 30, 0.4, "what was above is left");
}

TEST_F(Lenses, PanoramaIsEquirectangular) {
  const Lens lens{LensKind::panorama, 50, 1};
  for (const double right_deg : {-120.0, 0.0, 50.0})
    for (const double elevation_deg : {-30.0, 20.0})
      expect_pixel(sun_at(lens, {camera_m, 10, 0, 0}, 10 + right_deg, elevation_deg), 40 + 80 * right_deg / 360,
                   30 - 60 * elevation_deg / 180, 0.6, std::to_string(right_deg));
}

TEST_F(Lenses, FisheyeIsEquidistantAndRound) {
  const Lens lens{LensKind::fisheye, 50, 1};
  for (const double angle_deg : {0.0, 30.0, 60.0}) {  // from the line of sight
    expect_pixel(sun_at(lens, {camera_m, 90, 0, 0}, 90 + angle_deg, 0), 40 + 30 * angle_deg / 90, 30, 0.4, "right");
    expect_pixel(sun_at(lens, {camera_m, 90, 0, 0}, 90, angle_deg), 40, 30 - 30 * angle_deg / 90, 0.4, "up");
  }
  Cloudscape sky = empty_world();
  sky.sky.kind = SkyKind::uniform;
  sky.sky.radiance = glm::dvec3(1);
  FrameRequest request = picture(sky, {camera_m, 0, 0, 0}, {60, 60});
  request.lens = lens;
  const Frame frame = render(request);
  EXPECT_EQ(red(frame, 30 * 60 + 30), 1);
  EXPECT_EQ(red(frame, 0), 0) << "outside the circle";
  double circle = 0;
  for (int pixel = 0; pixel < 60 * 60; ++pixel) circle += red(frame, pixel);
  EXPECT_NEAR(circle / (std::numbers::pi * 30 * 30), 1, 0.01);
}

TEST_F(Lenses, OrthographicHasParallelRaysInMetres) {
  Cloudscape sky = homogeneous(VolumeKind::sphere, glm::dvec3(120, 2000, 1060) - 20.0, glm::dvec3(40), 1);
  FrameRequest request = picture(sky, {camera_m, 0, 0, 0}, size_px);
  request.lens = {LensKind::orthographic, 50, 400};  // 5 m a pixel
  expect_pixel(bright_spot(render(request), 3), 40 + 120 / 5.0, 30 - 60 / 5.0, 0.1, "120 m right, 60 m up");
  request.pose.position_m.y = -5000;
  expect_pixel(bright_spot(render(request), 3), 40 + 120 / 5.0, 30 - 60 / 5.0, 0.1, "from farther away");
}

TEST(CameraAxes, AreOrthonormalAndRightHandedForAnyPose) {
  for (const double azimuth_deg : {-400.0, 0.0, 77.0, 180.0})
    for (const double elevation_deg : {-90.0, -20.0, 0.0, 65.0, 90.0})
      for (const double roll_deg : {-200.0, 0.0, 33.0}) {
        const CameraAxes axes = camera_axes({{}, azimuth_deg, elevation_deg, roll_deg});
        EXPECT_NEAR(glm::dot(axes.right, axes.up), 0, 1e-12);
        EXPECT_NEAR(glm::dot(axes.right, axes.forward), 0, 1e-12);
        EXPECT_NEAR(glm::length(axes.right) * glm::length(axes.up) * glm::length(axes.forward), 1, 1e-12);
        EXPECT_NEAR(glm::length(glm::cross(axes.right, axes.up) + axes.forward), 0, 1e-12);
      }
}

TEST(CameraAxes, AzimuthGoesClockwiseFromNorth) {
  EXPECT_NEAR(glm::length(camera_axes({{}, 0, 0, 0}).forward - glm::dvec3(0, 1, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::length(camera_axes({{}, 90, 0, 0}).forward - glm::dvec3(1, 0, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::length(camera_axes({{}, 0, 90, 0}).forward - glm::dvec3(0, 0, 1)), 0, 1e-12);
}

}  // namespace
}  // namespace cloudscape::render
