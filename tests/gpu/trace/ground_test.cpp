// The ground as paths meet it, against closed forms.
#include "traced.h"

namespace cloudscape::render {
namespace {

using TracedGround = TraceTest;

Cloudscape bare_ground(double albedo) {
  Cloudscape sky = empty_world();
  sky.ground.kind = GroundKind::plain;
  sky.ground.albedo = glm::dvec3(albedo);
  sky.ground.variation = 0;
  return sky;
}

TEST_F(TracedGround, InTheSunIsADiffuseSurface) {
  Cloudscape sky = bare_ground(0.5);
  sky.sun.elevation_deg = 30;
  const Measured seen = measured(traced(traced_beam(sky, {{0, 0, 1000}, 0, -60, 0}, 8, 64)));
  EXPECT_NEAR(seen.over(0.5 / std::numbers::pi * std::sin(radians(30))), 1, 1e-3);
}

TEST_F(TracedGround, OfWaterIsADiffuseSurfaceAtItsLevel) {
  Cloudscape sky = bare_ground(0.5);
  sky.ground.kind = GroundKind::none;
  sky.ground.water.level_m = 200, sky.ground.water.albedo = glm::dvec3(0.1);
  sky.sun.elevation_deg = 30;
  const Frame frame = traced(traced_beam(sky, {{0, 0, 1000}, 0, -90, 0}, 8, 64));
  EXPECT_NEAR(measured(frame).over(0.166 / std::numbers::pi * std::sin(radians(30))), 1, 1e-3);
  EXPECT_NEAR(depth_m(frame), 800, 1);
}

TEST_F(TracedGround, IsLitByTheWholeSky) {
  Cloudscape sky = bare_ground(0.3);
  sky.sun.irradiance = glm::dvec3(0);
  sky.sky = {SkyKind::uniform, glm::dvec3(2)};
  const Measured seen = measured(traced(traced_beam(sky, {{0, 0, 1000}, 0, -40, 0}, 8, 64)));
  EXPECT_NEAR(seen.mean, 0.3 * 2, 4 * seen.error + 1e-4);  // weak paths end by roulette: on average
}

// White ground below clouds that do not absorb, in a sky that is the same all round: nothing can be seen.
TEST_F(TracedGround, WhiteFurnaceWithClouds) {
  Cloudscape sky = small_clouds();
  sky.ground = bare_ground(1).ground;
  sky.sun.irradiance = glm::dvec3(0);
  sky.sky = {SkyKind::uniform, glm::dvec3(0.5)};
  const Frame frame = traced(traced_picture(sky, {{2000, 2000, 500}, 45, 0, 0}, {24, 16}, 8));
  for (int pixel = 0; pixel < 24 * 16; ++pixel) ASSERT_NEAR(red(frame, pixel), 0.5, 1e-5);
}

// Lambert-Beer for the sun on its way to the ground: the shadow of a slab that absorbs all.
TEST_F(TracedGround, LiesInTheShadowOfAnAbsorber) {
  Cloudscape sky = homogeneous(VolumeKind::slab, {0, 0, 500}, {1000, 1000, 200}, 0.005);
  sky.ground = bare_ground(0.5).ground;
  sky.medium.single_scattering_albedo = 0;
  sky.sun.elevation_deg = 50;
  const double mu = std::sin(radians(50));
  const Measured seen = measured(traced(traced_beam(sky, {{0, 0, 300}, 0, -60, 0}, 16, 256)));
  EXPECT_NEAR(seen.over(0.5 / std::numbers::pi * mu * std::exp(-1 / mu)), 1, 4 * seen.error / seen.mean + 2e-3);
}

}  // namespace
}  // namespace cloudscape::render
