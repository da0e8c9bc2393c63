// One renderer for all tests of the program, without a disk cache; documents with closed-form answers; and what one
// reads off a frame.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "render/renderer.h"

namespace cloudscape::render {

// Everything that renders, on this thread, from birth to death.
struct Stack {
  explicit Stack(gpu::PassExecution execution = gpu::PassExecution::automatic, std::filesystem::path height_maps = {},
                 std::filesystem::path volumes = {})
      : context({.execution = execution}),
        bakes(context, shaders, bake::BakeCache({}, 0), std::uint64_t{1} << 30, {}, std::move(volumes)),
        renderer(context, shaders, bakes, std::move(height_maps)) {}
  gpu::Context context;
  gpu::ShaderLibrary shaders;
  bake::BakeStore bakes;
  Renderer renderer;
};

class RenderTest : public testing::Test {
 protected:
  RenderTest() {
    if (!shared_) shared_ = std::make_unique<Stack>();
    errors_before_ = shared_->context.gl_errors();
  }
  void TearDown() override {
    shared_->context.finish();
    EXPECT_EQ(shared_->context.gl_errors(), errors_before_) << "OpenGL reported errors (see the log)";
  }
  static Stack& stack() { return *shared_; }
  static Renderer& renderer() { return shared_->renderer; }
  static Frame render(const FrameRequest& request) {
    Frame frame = renderer().render(request);
    renderer().forget(request.stream);
    return frame;
  }

 private:
  friend class OwnStackTest;
  friend class EndOfStack;
  static inline std::unique_ptr<Stack> shared_;
  int errors_before_ = 0;
};

// A driver may be gone before what is static is destroyed.
class EndOfStack : public testing::Environment {
 public:
  void TearDown() override { RenderTest::shared_.reset(); }
};
inline testing::Environment* const end_of_stack = testing::AddGlobalTestEnvironment(new EndOfStack);

// For tests that make a stack themselves: a thread has one context at a time.
class OwnStackTest : public testing::Test {
 protected:
  OwnStackTest() { RenderTest::shared_.reset(); }
};

inline double radians(double degrees) { return degrees * std::numbers::pi / 180; }
inline double degrees(double radians) { return radians * 180 / std::numbers::pi; }

// Nothing but the sun, of irradiance 1, without a visible disc.
inline Cloudscape empty_world() {
  Cloudscape sky;
  sky.volume.kind = VolumeKind::sphere;
  sky.medium.extinction_per_m = 0;
  sky.medium.ambient = 0;
  sky.medium.light_model.kind = LightModelKind::single;
  sky.sky.kind = SkyKind::none;
  sky.ground.kind = GroundKind::none;
  sky.sun.irradiance = glm::dvec3(1);
  sky.sun.disc = false;
  return sky;
}

// No cloud, a clear sky, and the sun in the north.
inline Cloudscape clear_world(double sun_deg, double albedo = 0) {
  Cloudscape sky = empty_world();
  sky.sky.kind = SkyKind::clear;
  sky.ground.kind = GroundKind::plain;
  sky.ground.albedo = glm::dvec3(albedo);
  sky.ground.variation = 0;
  sky.sun.azimuth_deg = 0, sky.sun.elevation_deg = sun_deg;
  return sky;
}

inline Cloudscape homogeneous(VolumeKind kind, const glm::dvec3& low_m, const glm::dvec3& size_m,
                              double extinction_per_m) {
  Cloudscape sky = empty_world();
  sky.volume.kind = kind;
  sky.volume.origin_m = low_m;
  sky.volume.size_m = size_m;
  sky.medium.extinction_per_m = extinction_per_m;
  return sky;
}

// A ball of this radius (or a Gaussian of s = radius / 4) 1000 m north of a camera at altitude 1000 m.
constexpr glm::dvec3 camera_m{0, 0, 1000}, ball_center_m{0, 1000, 1000};
inline Cloudscape ball(double radius_m, double optical_radius, VolumeKind kind = VolumeKind::sphere) {
  return homogeneous(kind, ball_center_m - radius_m, glm::dvec3(2 * radius_m), optical_radius / radius_m);
}

// A cheap noise layer: a small tile with clouds nearly everywhere.
inline Cloudscape small_clouds() {
  Cloudscape sky;
  sky.medium.light_model.kind = LightModelKind::beer_octaves;  // which needs no time
  sky.seed = 3;
  sky.volume.resolution = 16;
  sky.detail.resolution = 16;
  sky.detail.period_m = 500;  // 16 to the volume's 8000 m
  sky.noise.channels[0].octaves = 2;
  for (int i = 1; i < 4; ++i) sky.noise.channels[i].octaves = 1;
  sky.shape.coverage = 0.8;
  return sky;
}

inline StreamId next_stream() {
  static StreamId stream = 0;
  return ++stream;
}

// One pixel, through the middle of the picture, with as little error as the renderer can.
inline FrameRequest one_ray(const Cloudscape& sky, const CameraPose& pose) {
  FrameRequest request;
  request.cloudscape = std::make_shared<const Cloudscape>(sky);
  request.pose = pose;
  request.size_px = {1, 1};
  request.quality = render_quality(Quality::finest);
  request.quality.samples = 1;  // later ones look beside the middle
  request.content = FrameContent::radiance;
  request.stream = next_stream();
  return request;
}

// The mean over where in their steps the samples lie; its rays keep within half a metre of the pose's.
inline FrameRequest one_beam(const Cloudscape& sky, const CameraPose& pose) {
  FrameRequest request = one_ray(sky, pose);
  request.lens = {LensKind::orthographic, 50, 1};
  request.quality.samples = 16;
  return request;
}

inline FrameRequest picture(const Cloudscape& sky, const CameraPose& pose, ImageSize size_px) {
  FrameRequest request = one_ray(sky, pose);
  request.size_px = size_px;
  request.quality = {.max_steps = 128, .step_m = 40, .step_growth = 0.02, .light_steps = 4, .float32 = true};
  return request;
}

inline double red(const Frame& frame, int pixel = 0) {
  return frame.radiance_rgba[4 * static_cast<std::size_t>(pixel)];
}
inline double opacity(const Frame& frame, int pixel = 0) {
  return frame.radiance_rgba[4 * static_cast<std::size_t>(pixel) + 3];
}
inline double depth_m(const Frame& frame, int pixel = 0) { return frame.depth_m[static_cast<std::size_t>(pixel)]; }

inline double henyey_greenstein(double cos_theta, double g) {
  return (1 - g * g) / (4 * std::numbers::pi * std::pow(1 + g * g - 2 * g * cos_theta, 1.5));
}

}  // namespace cloudscape::render
