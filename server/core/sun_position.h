// Where sun, moon and stars stand at a place and a time. Angles in degrees; azimuth clockwise from north, elevation
// above the horizon as it is seen, refraction included.
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string_view>

#include "core/cloudscape.h"

namespace cloudscape {

struct HorizontalPosition {
  double azimuth_deg = 0, elevation_deg = 0;
};

// Days since noon of January 1, 4713 BC, from "2026-06-21T12:00:00Z" (seconds may have decimals); nullopt where it is
// no such time, or not between 1901 and 2099.
std::optional<double> julian_day(std::string_view time_utc);

// Refraction of an object at a true elevation (NOAA's solar calculator; sea level, mean weather).
double refraction_deg(double true_elevation_deg);

// NOAA's solar calculator (after Meeus, "Astronomical Algorithms", 1991); within 0.02 degrees from 1901 to 2099 and
// outside the last degree above the horizon, where weather matters more.
HorizontalPosition sun_position(double julian_day, double latitude_deg, double longitude_deg);

// The Astronomical Almanac's low-precision formula, within 0.3 degrees; seen from the place, not from the earth's
// middle.
HorizontalPosition moon_position(double julian_day, double latitude_deg, double longitude_deg);

struct EclipticPosition {
  double longitude_deg = 0, latitude_deg = 0, parallax_deg = 0;
};
EclipticPosition moon_ecliptic(double julian_day);

// World directions of the star sphere's axes: right ascension 0, 90 degrees, the pole.
std::array<glm::dvec3, 3> star_axes(double julian_day, double latitude_deg, double longitude_deg);

// The Julian day at a place when the clock shows `time_s`; nullopt where the place has no time. It goes in steps of 4
// s, in which the sun moves by a thirtieth of its width: what depends on the sun need not be computed more often.
std::optional<double> julian_day_at(const Place& place, double time_s);

// Puts sun and moon where they stand at sun.place; nothing where it has no time.
void place_sun_and_moon(Cloudscape& cloudscape, double time_s = 0);

// The document as it is when the clock shows `time_s`; itself where its sun stands still.
std::shared_ptr<const Cloudscape> at_time(const std::shared_ptr<const Cloudscape>& cloudscape, double time_s);

}  // namespace cloudscape
