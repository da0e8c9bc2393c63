// Sun and moon in moving pictures, whose marched pixels mostly miss them.
#include "render/discs.h"

#include "gpu/render/fixture.h"

namespace cloudscape::render {
namespace {

// Towards the sun, one in sixteen of a quarter as many pixels each way.
FrameRequest towards_the_sun(StreamId stream) {
  FrameRequest request;
  auto sky = std::make_shared<Cloudscape>(clear_world(20));
  sky->sun.disc = true;
  request.cloudscape = sky;
  request.pose.position_m = {0, 0, 200};
  request.pose.azimuth_deg = -6, request.pose.elevation_deg = 18;
  request.size_px = {256, 144};
  request.quality = render_quality(Quality::interactive);
  request.quality.reuse = 16, request.quality.resolution_divisor = 4;
  request.display.dither = false;
  request.display.bloom_strength = 0;
  request.stream = stream;
  return request;
}

// Of the shown picture.
int green_at(const Frame& frame, const glm::dvec2& px) {
  const auto column = static_cast<std::size_t>(px.x), row = static_cast<std::size_t>(px.y);
  return frame.display_rgba[4 * (row * static_cast<std::size_t>(frame.request.size_px.width) + column) + 1];
}

// Where the shown picture has the middle of a disc.
glm::dvec2 shown_px(const FrameRequest& request, const glm::dvec3& disc_px) {
  const ResolvePlan plan = resolve_plan(request);
  return (glm::dvec2(disc_px) - plan.margin_px) * static_cast<double>(plan.divisor);
}

Discs discs_in(const FrameRequest& request) {
  const ResolvePlan plan = resolve_plan(request);
  return discs_of(kept_view(request, plan), plan.kept);
}

class MovingDiscs : public RenderTest {
 protected:
  // Calls back with each frame of a turn.
  static void turn(FrameRequest request, double turn_deg, const std::function<void(const Frame&)>& seen) {
    for (int i = 0; i < 20; ++i) {
      seen(renderer().render(request));
      request.pose.azimuth_deg += turn_deg;
    }
    renderer().forget(request.stream);
  }
};

TEST(DiscsTest, lie_where_the_picture_shows_them) {
  FrameRequest request = towards_the_sun(1);
  request.pose.azimuth_deg = 0, request.pose.elevation_deg = 20;
  const ResolvePlan plan = resolve_plan(request);
  const glm::dvec3 middle = discs_in(request).sun_px;
  EXPECT_NEAR(middle.x, 0.5 * plan.kept.width, 1e-9);
  EXPECT_NEAR(middle.y, 0.5 * plan.kept.height, 1e-9);
  request.pose.azimuth_deg = -10, request.pose.elevation_deg = 15;
  const glm::dvec3 aside = discs_in(request).sun_px;
  EXPECT_GT(aside.x, middle.x + 5);
  EXPECT_LT(aside.y, middle.y - 3);
  request.pose.azimuth_deg = 90;
  EXPECT_EQ(discs_in(request).sun_px.z, 0) << "it is not in the picture";
  // Beside the camera, where a disc would be stretched over the whole picture.
  for (const double aside_deg : {50.0, 80.0, 88.0, 89.9})
    for (const double towards : {-1.0, 1.0}) {
      request.pose.azimuth_deg = towards * aside_deg;
      EXPECT_EQ(discs_in(request).sun_px.z, 0) << towards * aside_deg;
    }
  request.pose.azimuth_deg = 180, request.pose.elevation_deg = -20;
  EXPECT_EQ(discs_in(request).sun_px.z, 0) << "it is behind the camera";
}

TEST(DiscsTest, are_as_large_as_in_the_sky_or_as_a_pixel) {
  FrameRequest request = towards_the_sun(1);
  request.pose.azimuth_deg = 0, request.pose.elevation_deg = 20;
  EXPECT_NEAR(discs_in(request).sun_px.z, 1.2, 1e-9);
  auto sky = std::make_shared<Cloudscape>(*request.cloudscape);
  sky->sun.angular_radius_deg = 5;
  request.cloudscape = sky;
  const ResolvePlan plan = resolve_plan(request);
  const double half = half_height_of(kept_view(request, plan).vertical_fov_deg);
  EXPECT_NEAR(discs_in(request).sun_px.z, radians(5) / (2 * half) * plan.kept.height, 1e-9);
}

// As much light comes from it as before.
TEST(DiscsTest, widened_sun_is_as_bright) {
  const FrameRequest request = towards_the_sun(1);
  const FrameBlock narrow = frame_block(request, 0);
  FrameBlock wide = narrow;
  widen_discs(wide, {64, 36}, 60);
  EXPECT_GT(wide.sun_direction.w, 4 * narrow.sun_direction.w);
  EXPECT_NEAR(wide.sun_direction.w * wide.sun_irradiance.w, narrow.sun_direction.w * narrow.sun_irradiance.w, 1e-6);
  FrameBlock same = narrow;
  widen_discs(same, {6400, 3600}, 60);
  EXPECT_EQ(same.sun_direction.w, narrow.sun_direction.w);
}

// Without rays of its own the sun went out wherever the frame's rays missed it.
TEST_F(MovingDiscs, sun_is_in_every_frame_of_a_turn) {
  turn(towards_the_sun(next_stream()), 0.7, [](const Frame& frame) {
    const glm::dvec2 sun = shown_px(frame.request, discs_in(frame.request).sun_px);
    EXPECT_GE(green_at(frame, sun), 235);
    EXPECT_LT(green_at(frame, sun + glm::dvec2(24, 0)), 200) << "it leaves no trail";
    EXPECT_LT(green_at(frame, sun - glm::dvec2(24, 0)), 200);
  });
}

TEST_F(MovingDiscs, moon_is_in_every_frame_of_a_turn) {
  FrameRequest request = towards_the_sun(next_stream());
  auto night = std::make_shared<Cloudscape>(*request.cloudscape);
  night->sun.azimuth_deg = 180, night->sun.elevation_deg = -30;
  night->moon.azimuth_deg = 0, night->moon.elevation_deg = 20;
  night->sky.stars = 0;
  request.cloudscape = night;
  request.display.exposure_ev = 10;
  turn(request, 0.7, [](const Frame& frame) {
    const glm::dvec2 moon = shown_px(frame.request, discs_in(frame.request).moon_px);
    EXPECT_GE(green_at(frame, moon), 130);
    EXPECT_LT(green_at(frame, moon + glm::dvec2(24, 0)), 100);
    EXPECT_LT(green_at(frame, moon - glm::dvec2(24, 0)), 100);
  });
}

// Behind a thick cloud its rays would only add noise.
TEST_F(MovingDiscs, hidden_sun_adds_nothing) {
  const auto last = [](bool disc) {
    FrameRequest request = towards_the_sun(next_stream());
    auto sky = std::make_shared<Cloudscape>(*request.cloudscape);
    sky->volume.kind = VolumeKind::box;
    sky->volume.origin_m = {-4000, -4000, 1000}, sky->volume.size_m = {8000, 8000, 1000};
    sky->medium.extinction_per_m = 0.1;
    sky->sun.disc = disc;
    request.cloudscape = sky;
    std::vector<std::uint8_t> rgba;
    turn(request, 0.7, [&](const Frame& frame) { rgba = frame.display_rgba; });
    return rgba;
  };
  EXPECT_EQ(last(true), last(false));
}

}  // namespace
}  // namespace cloudscape::render
