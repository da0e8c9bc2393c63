// The sky tables against the Monte Carlo tracer (traced_air.h), and what may not happen to a sky.
#include <cstdlib>
#include <sstream>

#include "fixture.h"
#include "render/block_values.h"
#include "render/sky_tables.h"
#include "traced_air.h"

namespace cloudscape::render {
namespace {

// Directions to look at, azimuth from the sun.
struct Look {
  double azimuth_deg, elevation_deg;
};

class ClearSky : public RenderTest {
 protected:
  static glm::dvec3 color(const Frame& frame, std::size_t pixel = 0) {
    const float* rgba = frame.radiance_rgba.data() + 4 * pixel;
    return {rgba[0], rgba[1], rgba[2]};
  }
  static glm::dvec3 sky_at(const Cloudscape& sky, double altitude_m, const Look& look) {
    return color(render(one_ray(sky, {{0, 0, altitude_m}, look.azimuth_deg, look.elevation_deg, 0})));
  }
  // The relative error of each colour lies within the limits, but for the tracer's noise.
  static void check_error(const glm::dvec3& ours, const TracedRadiance& truth, double low, double high,
                          const std::string& where) {
    const glm::dvec3 error = ours / truth.mean - 1.0, noise = truth.error / truth.mean;
    for (int i = 0; i < 3; ++i) {
      EXPECT_GT(error[i], low - 3 * noise[i]) << where << ", channel " << i;
      EXPECT_LT(error[i], high + 3 * noise[i]) << where << ", channel " << i;
    }
    if (std::getenv("CLOUDSCAPE_PRINT"))
      std::printf("%s: %+.3f %+.3f %+.3f (noise %.3f %.3f %.3f)\n", where.c_str(), error.x, error.y, error.z, noise.x,
                  noise.y, noise.z);
  }
  static void compare(double sun_deg, double albedo, const Look& look, double low, double high, double altitude_m = 2,
                      int paths = 5000) {
    const TracedAir air{direction_of(0, sun_deg), albedo};
    const TracedRadiance truth = traced_sky(air, altitude_m, direction_of(look.azimuth_deg, look.elevation_deg), paths);
    std::ostringstream where;
    where << "sun " << sun_deg << ", albedo " << albedo << ", azimuth " << look.azimuth_deg << ", elevation "
          << look.elevation_deg << ", from " << altitude_m << " m";
    check_error(sky_at(clear_world(sun_deg, albedo), altitude_m, look), truth, low, high, where.str());
  }
};

TEST_F(ClearSky, MeetsTheTracerOverBlackGround) {
  for (const double sun_deg : {60.0, 30.0})
    for (const Look look : {Look{90, 90}, Look{0, 45}, Look{180, 45}}) compare(sun_deg, 0, look, -0.06, 0.06);
  for (const double sun_deg : {60.0, 30.0})
    for (const Look look : {Look{90, 10}, Look{180, 10}}) compare(sun_deg, 0, look, -0.06, 0.06);
  for (const Look look : {Look{90, 90}, Look{90, 45}, Look{90, 10}, Look{180, 2}}) compare(5, 0, look, -0.06, 0.06);
}

TEST_F(ClearSky, MeetsTheTracerOverGreyGround) {
  for (const double sun_deg : {60.0, 30.0, 5.0})
    for (const Look look : {Look{90, 90}, Look{180, 45}, Look{90, 10}}) compare(sun_deg, 0.3, look, -0.06, 0.06);
}

TEST_F(ClearSky, MeetsTheTracerInTwilight) {
  for (const Look look : {Look{0, 10}, Look{90, 60}, Look{180, 20}}) {
    compare(-2, 0.1, look, -0.15, 0.15);
    compare(-4, 0.1, look, -0.15, 0.15, 2, 40000);
  }
}

// From above, down to the ground.
TEST_F(ClearSky, MeetsTheTracerFromAbove) {
  for (const double altitude_m : {3000.0, 12000.0})
    for (const double sun_deg : {30.0, 5.0})
      for (const Look look : {Look{90, -80}, Look{180, -20}, Look{0, -6}})
        compare(sun_deg, 0.3, look, -0.08, 0.12, altitude_m);
}

// To a black ball in the air.
TEST_F(ClearSky, MeetsTheTracerBeforeAnObject) {
  for (const double distance_m : {3000.0, 20000.0, 80000.0})
    for (const double sun_deg : {30.0, 3.0})
      for (const double azimuth_deg : {0.0, 90.0, 180.0}) {
        const Look look{azimuth_deg, 2};
        const TracedAir air{direction_of(0, sun_deg), 0};
        const glm::dvec3 direction = direction_of(azimuth_deg, 2);
        const TracedRadiance truth = traced_sky(air, 1000, direction, 5000, distance_m);
        Cloudscape sky = clear_world(sun_deg);
        sky.volume.size_m = glm::dvec3(400);
        sky.volume.origin_m = glm::dvec3(0, 0, 1000) + direction * (distance_m + 200) - 200.0;
        sky.medium.extinction_per_m = 10, sky.medium.single_scattering_albedo = 0;
        check_error(sky_at(sky, 1000, look), truth, -0.08, 0.08,
                    "distance " + std::to_string(distance_m) + " sun " + std::to_string(sun_deg) + " azimuth " +
                        std::to_string(azimuth_deg));
      }
}

double luminance(const glm::dvec3& color) { return glm::dot(color, glm::dvec3(0.2126, 0.7152, 0.0722)); }

// Twilight: darker the lower the sun stands, by about as much as is measured (a factor 400 to 4000 from sunset to -6,
// from there to -12 as much again), never negative, and brighter in the west.
TEST_F(ClearSky, DarkensThroughTwilight) {
  double before = 1e9;
  for (const double sun_deg : {0.0, -2.0, -4.0, -6.0, -9.0, -12.0, -15.0, -18.0}) {
    Cloudscape sky = clear_world(sun_deg, 0.1);
    sky.sky.stars = 0;
    const double zenith = luminance(sky_at(sky, 2, {0, 89}));
    EXPECT_LT(zenith, before) << sun_deg;
    EXPECT_GE(zenith, 0) << sun_deg;
    EXPECT_GT(luminance(sky_at(sky, 2, {0, 3})), luminance(sky_at(sky, 2, {180, 3}))) << sun_deg;
    before = zenith;
  }
  const auto zenith = [](double sun_deg) { return luminance(sky_at(clear_world(sun_deg, 0.1), 2, {0, 89})); };
  EXPECT_GT(zenith(0) / zenith(-6), 20);
  EXPECT_LT(zenith(0) / zenith(-6), 400);
  EXPECT_GT(zenith(-6) / zenith(-12), 50);
}

// Nothing jumps as the camera climbs, least of all where the levels of the tables meet.
TEST_F(ClearSky, ChangesEvenlyWithAltitude) {
  const Cloudscape sky = clear_world(8, 0.2);
  for (const int level : {1, 5, 12}) {
    const double rung_m = level_altitude_m(level);
    for (const Look look : {Look{30, 2}, Look{120, 40}, Look{60, -20}}) {
      const glm::dvec3 below = sky_at(sky, rung_m * 0.999, look), above = sky_at(sky, rung_m * 1.001, look);
      EXPECT_NEAR(luminance(above) / luminance(below), 1, 0.004) << "level " << level << " look " << look.elevation_deg;
    }
  }
}

// What a flight's view is blended for lies so near that nobody sees it change.
TEST_F(ClearSky, OfSixteenthsOfARungIsTheSame) {
  const Cloudscape sky = clear_world(8, 0.2);
  for (const double altitude_m : {3.0, 70.0, 1234.0, 9876.0}) {
    const double blended_m = blended_altitude_m(altitude_m);
    EXPECT_NEAR(blended_altitude_m(blended_m), blended_m, 1e-6);
    EXPECT_LE(std::abs(blended_m - altitude_m), (62.5 + altitude_m / 4) / 32);
    for (const Look look : {Look{30, 2}, Look{120, 40}, Look{60, -20}}) {
      const double there = luminance(sky_at(sky, altitude_m, look)), near = luminance(sky_at(sky, blended_m, look));
      EXPECT_NEAR(near / there, 1, 0.006) << altitude_m << " look " << look.elevation_deg;
    }
  }
}

TEST_F(ClearSky, IsNotComputedAnewWhereOnlyTheCameraMoves) {
  const FrameRequest request = one_ray(clear_world(20), {{0, 0, 800}, 0, 10, 0});
  const auto bakes_of = [&](const CameraPose& pose, const Cloudscape& sky) {
    FrameRequest moved = request;
    moved.pose = pose, moved.cloudscape = std::make_shared<const Cloudscape>(sky);
    const int before = renderer().sky_bakes();
    render(moved);
    return renderer().sky_bakes() - before;
  };
  const Cloudscape sky = *request.cloudscape;
  bakes_of({{0, 0, 800}, 0, 10, 0}, sky);
  EXPECT_EQ(bakes_of({{0, 0, 800}, 200, -30, 10}, sky), 0);
  EXPECT_EQ(bakes_of({{5e5, -2e4, 800}, 0, 10, 0}, sky), 0);
  EXPECT_EQ(bakes_of({{0, 0, 850}, 0, 10, 0}, sky), 0);  // the same two levels
  Cloudscape turned = sky;
  turned.sun.azimuth_deg = 77;
  EXPECT_EQ(bakes_of({{0, 0, 800}, 0, 10, 0}, turned), 0);  // tables turn with the sun
  Cloudscape lower = sky;
  lower.sun.elevation_deg = 19;
  // Domes and aerial perspectives of two levels, and what lights the clouds; not the air.
  EXPECT_EQ(bakes_of({{0, 0, 800}, 0, 10, 0}, lower), 5);
}

// A sun that climbs is followed table by table, and shown as it is some frames after it stands.
TEST_F(ClearSky, MayLagBehindItsSunByAFewFrames) {
  FrameRequest request = picture(clear_world(20), {{0, 0, 800}, 0, 10, 0}, {8, 8});
  request.stream = next_stream();
  renderer().render(request);
  request.light_may_lag = true;
  const auto render_at = [&](double sun_deg) {
    request.cloudscape = std::make_shared<const Cloudscape>(clear_world(sun_deg));
    const int before = renderer().sky_bakes();
    const Frame frame = renderer().render(request);
    EXPECT_LE(renderer().sky_bakes() - before, 2) << "what lights the clouds, and one table";
    return luminance(color(frame, 3));
  };
  const double first = render_at(20.0);
  for (int frame = 1; frame <= 20; ++frame) render_at(20.0 - frame);
  const double lagging = render_at(0.0);
  for (int frame = 0; frame < 4; ++frame) render_at(0.0);
  const double settled = render_at(0.0);
  request.light_may_lag = false;
  EXPECT_EQ(settled, render_at(0.0));
  EXPECT_LT(lagging, 0.5 * (first + settled)) << "it follows";
}

// Frames of a moving picture do it by turns with shadows and, above water, with another sky and the clouds in it; and
// it comes to an end.
TEST_F(ClearSky, IsRenewedByTurnsInMovingPictures) {
  for (const bool water : {false, true}) {
    FrameRequest request = picture(clear_world(20), {{0, 0, 800}, 0, 10, 0}, {32, 16});
    request.content = FrameContent::display;
    request.quality.reuse = 16;
    request.stream = next_stream();
    const auto bakes_at = [&](double sun_deg, bool may_lag) {
      Cloudscape sky = clear_world(sun_deg);
      if (water) sky.ground.water.level_m = 0;
      request.cloudscape = std::make_shared<const Cloudscape>(sky);
      request.light_may_lag = may_lag;
      const int before = renderer().sky_bakes();
      renderer().render(request);
      return renderer().sky_bakes() - before;
    };
    bakes_at(21.13, false);
    const int round = water ? 4 : 2, skies = water ? 2 : 1;
    for (int rounds = 0; rounds < 4; ++rounds) {
      int busy = 0;
      for (int frame = 0; frame < round; ++frame) {
        const int bakes = bakes_at(21.13 - 0.3 * (round * rounds + frame), true);
        EXPECT_LE(bakes, 2) << "what lights the clouds, and one table";
        busy += bakes > 0 ? 1 : 0;
      }
      EXPECT_EQ(busy, skies);
    }
    int settling = 0;
    for (int frame = 0; frame < 5 * round; ++frame) settling += bakes_at(9.37, true);
    EXPECT_EQ(settling, 1 + 4 * skies);
    for (int frame = 0; frame < round; ++frame) EXPECT_EQ(bakes_at(9.37, true), 0);
    EXPECT_EQ(bakes_at(9.37, false), 0) << "all is there";
    renderer().forget(request.stream);
  }
}

// Half a degree of sky about the horizon: no stripe brighter or darker than what lies about it.
TEST_F(ClearSky, HasNoStripeAtTheHorizon) {
  for (const double sun_deg : {30.0, 2.0}) {
    FrameRequest request = picture(clear_world(sun_deg, 0.2), {{0, 0, 100}, 90, -0.32, 0}, {1, 64});
    request.lens.vertical_fov_deg = 1;
    const Frame frame = render(request);
    for (std::size_t pixel = 1; pixel + 1 < 64; ++pixel) {
      const double here = luminance(color(frame, pixel)), up = luminance(color(frame, pixel - 1)),
                   down = luminance(color(frame, pixel + 1));
      EXPECT_LT(here, 1.05 * std::max(up, down)) << pixel;
      EXPECT_GT(here, 0.95 * std::min(up, down)) << pixel;
    }
  }
}

TEST_F(ClearSky, MoonAndStarsShineAtNight) {
  Cloudscape sky = clear_world(-40, 0.2);
  sky.moon.azimuth_deg = 180, sky.moon.elevation_deg = 40;  // nearly full
  const double moonlit = luminance(sky_at(sky, 2, {90, 60}));
  Cloudscape dark = sky;
  dark.moon.brightness = 0;
  const double starlit = luminance(sky_at(dark, 2, {90, 60}));
  // About two orders of magnitude lie between a night of full moon and one without.
  EXPECT_GT(moonlit, 10 * starlit);
  EXPECT_GT(starlit, 0);
  sky.sun.elevation_deg = 40, sky.moon.brightness = 0;
  EXPECT_NEAR(std::log10(luminance(sky_at(sky, 2, {90, 60})) / moonlit), 5.6,
              0.4);  // the sun is 400,000 times the moon
}

TEST_F(ClearSky, TheMoonsDiscCarriesItsLight) {
  Cloudscape sky = clear_world(-40);
  sky.sky.stars = 0, sky.sky.haze = 0, sky.sky.rayleigh = 0, sky.sky.ozone = 0;
  sky.moon.azimuth_deg = 0, sky.moon.elevation_deg = 30, sky.moon.phase_angle_deg = 0;
  const double full = luminance(sky_at(sky, 2, {0, 30}));
  const double solid_angle = std::numbers::pi * std::pow(radians(0.259), 2);
  EXPECT_NEAR(full * solid_angle / 2.52e-6, 1, 0.06);  // magnitude -12.73 against -26.74
  sky.moon.phase_angle_deg = 180;
  EXPECT_LT(luminance(sky_at(sky, 2, {0, 30})), 1e-3 * full);
}

}  // namespace
}  // namespace cloudscape::render
