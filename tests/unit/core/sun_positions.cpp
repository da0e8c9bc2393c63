// Sun and moon against published positions.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/sun_position.h"

namespace cloudscape {
namespace {

double day_of(const char* time) { return julian_day(time).value(); }

TEST(JulianDay, IsThatOfThePublishedExamples) {
  EXPECT_DOUBLE_EQ(day_of("2000-01-01T12:00:00Z"), 2451545.0);        // Meeus, chapter 7
  EXPECT_DOUBLE_EQ(day_of("1957-10-04T19:26:24Z"), 2436116.31);       // Meeus, example 7.a
  EXPECT_DOUBLE_EQ(day_of("1987-06-19T12:00:00Z"), 2446966.0);        // Meeus, chapter 7
  EXPECT_NEAR(day_of("2003-10-17T19:30:30Z"), 2452930.312847, 1e-6);  // NREL SPA, appendix A.5
}

TEST(JulianDay, TakesSecondsWithDecimalsAndNone) {
  EXPECT_DOUBLE_EQ(day_of("2026-06-21T12:00Z"), day_of("2026-06-21T12:00:00Z"));
  EXPECT_NEAR(day_of("2026-06-21T12:00:30.5Z") - day_of("2026-06-21T12:00:00Z"), 30.5 / 86400, 1e-9);
}

TEST(JulianDay, RefusesWhatIsNoTime) {
  for (const char* text :
       {"", "now", "2026-06-21", "2026-06-21T12:00:00", "2026-13-01T00:00:00Z", "2026-02-29T00:00:00Z",
        "1900-01-01T00:00:00Z", "2100-01-01T00:00:00Z", "2026-06-21T24:00:00Z", "2026-06-21T12:60:00Z",
        "2026-06-21T12:00:00Z+1", "2026-06-2xT12:00:00Z", "-026-06-21T12:00:00Z", "2026-06-21T12:00:00+02:00"})
    EXPECT_FALSE(julian_day(text)) << text;
  EXPECT_TRUE(julian_day("2024-02-29T00:00:00Z"));
}

struct Example {
  const char* source;
  const char* time;
  double latitude_deg, longitude_deg, azimuth_deg, elevation_deg, tolerance_deg;
};

// NREL SPA has its own altitude, pressure and temperature; the geometry is the same within the tolerance.
const Example examples[] = {
    {"NREL SPA, appendix A.5 (zenith 50.11162, azimuth 194.34024)", "2003-10-17T19:30:30Z", 39.742476, -105.1786,
     194.34024, 39.88838, 0.01},
    {"Meeus, example 25.a: declination -7.78507 at 0 TD; seen from the pole (refraction 0.0422)",
     "1992-10-13T00:00:00Z", 90, 0, -1, -7.78507 + 0.0422, 0.005},
    {"June solstice 2026 at its instant: declination 23.4383, seen from the pole (refraction 0.037)",
     "2026-06-21T08:25:00Z", 90, 0, -1, 23.4383 + 0.0371, 0.01},
    {"December solstice 2026, the south pole", "2026-12-21T20:50:00Z", -90, 0, -1, 23.4383 + 0.0371, 0.01},
    {"March equinox 2026 (March 20, 14:46 UTC), seen from the pole: the sun's middle on the horizon, raised by 0.48",
     "2026-03-20T14:46:00Z", 90, 0, -1, 0.482, 0.03},
};

TEST(SunPosition, IsThatOfThePublishedExamples) {
  for (const Example& example : examples) {
    const HorizontalPosition sun = sun_position(day_of(example.time), example.latitude_deg, example.longitude_deg);
    EXPECT_NEAR(sun.elevation_deg, example.elevation_deg, example.tolerance_deg) << example.source;
    if (example.azimuth_deg >= 0) {
      EXPECT_NEAR(sun.azimuth_deg, example.azimuth_deg, example.tolerance_deg) << example.source;
    }
  }
}

// Almanac: the equation of time is +16.4 min on November 3 and -14.2 min on February 11; the sun transits that much
// before noon.
TEST(SunPosition, TransitsByTheEquationOfTime) {
  for (const auto& [time, minutes] : {std::pair{"2026-11-03T12:00:00Z", 16.45}, {"2026-02-11T12:00:00Z", -14.22}}) {
    const double transit = day_of(time) - minutes / 1440;
    EXPECT_NEAR(sun_position(transit, 50, 0).azimuth_deg, 180, 0.05) << time;
    EXPECT_NEAR(std::remainder(sun_position(transit, -50, 0).azimuth_deg, 360), 0, 0.05)
        << "in the north, seen from the south";
  }
}

TEST(SunPosition, RisesInTheEastAtEquinox) {
  const HorizontalPosition morning = sun_position(day_of("2026-03-20T07:00:00Z"), 0, 0);
  EXPECT_NEAR(morning.azimuth_deg, 90, 0.3);
  EXPECT_NEAR(morning.elevation_deg, 15 - 1.85, 0.15);  // an hour after 6, 7.4 minutes late
}

TEST(SunPosition, NeverSetsOnAPolarDay) {
  for (int hour = 0; hour < 24; ++hour) {
    const double day = day_of("2026-06-21T00:00:00Z") + hour / 24.0;
    EXPECT_GT(sun_position(day, 69.65, 18.96).elevation_deg, 3) << "Tromso, hour " << hour;
    EXPECT_LT(sun_position(day, -75, 18.96).elevation_deg, -7) << "Antarctica, hour " << hour;
  }
}

// NOAA's table of approximate atmospheric refraction, arc minutes at the horizon and above.
TEST(Refraction, IsNoaas) {
  EXPECT_NEAR(refraction_deg(0) * 60, 28.9, 0.1);  // true elevation 0: 1735 arc seconds
  EXPECT_NEAR(refraction_deg(10) * 3600, 58.1 / std::tan(0.1745329) - 0.07 / std::pow(std::tan(0.1745329), 3), 0.6);
  EXPECT_EQ(refraction_deg(90), 0);
  for (const double border : {5.0, -0.575})
    EXPECT_NEAR(refraction_deg(border - 1e-6), refraction_deg(border + 1e-6), 0.002) << border;
}

// Meeus, example 47.a: 1992 April 12, 0 TD: longitude 133.162655, latitude -3.229126, parallax 0.991990.
TEST(MoonPosition, IsThatOfMeeusExample) {
  const EclipticPosition moon = moon_ecliptic(day_of("1992-04-12T00:00:00Z"));
  EXPECT_NEAR(std::remainder(moon.longitude_deg - 133.162655, 360), 0, 0.3);
  EXPECT_NEAR(moon.latitude_deg, -3.229126, 0.2);
  EXPECT_NEAR(moon.parallax_deg, 0.991990, 0.005);
}

// Eclipses show where both stand: that of August 21, 2017 was total at Hopkinsville, Kentucky, about 18:25:30 UTC.
TEST(MoonPosition, CoversTheSunInAnEclipse) {
  const double day = day_of("2017-08-21T18:25:30Z");
  const HorizontalPosition sun = sun_position(day, 36.965, -87.67), moon = moon_position(day, 36.965, -87.67);
  EXPECT_NEAR(sun.azimuth_deg, 198, 1);
  EXPECT_NEAR(sun.elevation_deg, 64, 0.5);  // NASA's figures for the greatest eclipse
  EXPECT_NEAR(moon.elevation_deg, sun.elevation_deg, 0.3);
  EXPECT_NEAR(moon.azimuth_deg, sun.azimuth_deg, 0.7);
}

TEST(StarAxes, TurnOncePerSiderealDayAboutThePole) {
  const double day = day_of("2026-06-21T00:00:00Z");
  const auto before = star_axes(day, 50, 10), after = star_axes(day + 0.99726957, 50, 10);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(glm::dot(before[i], after[i]), 1, 1e-6);
  EXPECT_NEAR(before[2].y, std::cos(50 * 0.0174532925), 1e-6);  // the pole stands in the north, as high as the latitude
  EXPECT_NEAR(glm::dot(glm::cross(before[0], before[1]), before[2]), 1, 1e-9);
}

TEST(PlaceSunAndMoon, PutsThemThereOnlyAtATime) {
  Cloudscape sky;
  const Cloudscape before = sky;
  place_sun_and_moon(sky);
  EXPECT_EQ(sky, before);
  sky.sun.place = {39.742476, -105.1786, "2003-10-17T19:30:30Z"};
  place_sun_and_moon(sky);
  EXPECT_NEAR(sky.sun.azimuth_deg, 194.34, 0.01);
  EXPECT_NE(sky.moon.elevation_deg, before.moon.elevation_deg);
}

// The document as it is at a time is the document whose place has that time.
TEST(AtTime, TheSunGoesItsWay) {
  auto sky = std::make_shared<Cloudscape>();
  EXPECT_EQ(at_time(sky, 5000), sky) << "it has no place";
  sky->sun.place = {47.6, 9.4, "2026-06-21T04:00:00Z"};
  place_sun_and_moon(*sky);
  EXPECT_EQ(at_time(sky, 5000), sky) << "it stands still";
  sky->sun.place.time_rate = 60;
  EXPECT_EQ(at_time(sky, 0), sky);
  Cloudscape later = *sky;
  later.sun.place.time_utc = "2026-06-21T05:30:00Z";
  place_sun_and_moon(later);
  const auto moved = at_time(sky, 90);
  EXPECT_NEAR(moved->sun.azimuth_deg, later.sun.azimuth_deg, 1e-5);
  EXPECT_NEAR(moved->sun.elevation_deg, later.sun.elevation_deg, 1e-5);
  EXPECT_NEAR(moved->moon.azimuth_deg, later.moon.azimuth_deg, 1e-5);
  EXPECT_EQ(*at_time(moved, 90), *moved) << "a function of the time alone, however often";
  EXPECT_NEAR(at_time(sky, 86400.0 / 60)->sun.elevation_deg, sky->sun.elevation_deg, 0.3) << "a day later";
}

TEST(AtTime, TheSunMovesInStepsThatNobodySees) {
  const Place place{47.6, 9.4, "2026-06-21T04:00:00Z", 1};
  EXPECT_EQ(julian_day_at(place, 1.9), julian_day_at(place, 0));
  EXPECT_NEAR(*julian_day_at(place, 3) - *julian_day_at(place, 0), 4 / 86400.0, 1e-9);
  EXPECT_LT(std::abs(*julian_day_at(place, 1e6 + 0.7) - *julian_day_at(place, 0) - (1e6 + 0.7) / 86400), 2.1 / 86400);
}

}  // namespace
}  // namespace cloudscape
