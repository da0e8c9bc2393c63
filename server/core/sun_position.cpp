#include "core/sun_position.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

namespace cloudscape {
namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;
double sin_deg(double degrees) { return std::sin(degrees * radians_per_degree); }
double cos_deg(double degrees) { return std::cos(degrees * radians_per_degree); }
double tan_deg(double degrees) { return std::tan(degrees * radians_per_degree); }
double wrapped(double value, double period) { return value - period * std::floor(value / period); }
double centuries_since_2000(double julian_day) { return (julian_day - 2451545.0) / 36525.0; }

// Obliquity of the ecliptic, degrees.
double mean_obliquity_deg(double t) {
  return 23 + (26 + (21.448 - t * (46.815 + t * (0.00059 - t * 0.001813))) / 60) / 60;
}

struct EquatorialPosition {
  double hour_angle_deg, declination_deg;
};

HorizontalPosition horizontal(const EquatorialPosition& at, double latitude_deg) {
  const double up = sin_deg(latitude_deg) * sin_deg(at.declination_deg) +
                    cos_deg(latitude_deg) * cos_deg(at.declination_deg) * cos_deg(at.hour_angle_deg);
  const double north = cos_deg(latitude_deg) * sin_deg(at.declination_deg) -
                       sin_deg(latitude_deg) * cos_deg(at.declination_deg) * cos_deg(at.hour_angle_deg);
  const double east = -cos_deg(at.declination_deg) * sin_deg(at.hour_angle_deg);
  return {wrapped(std::atan2(east, north) / radians_per_degree, 360),
          std::asin(std::clamp(up, -1.0, 1.0)) / radians_per_degree};
}

HorizontalPosition seen(HorizontalPosition position) {
  position.elevation_deg = std::clamp(position.elevation_deg + refraction_deg(position.elevation_deg), -90.0, 90.0);
  return position;
}

// Greenwich's (Meeus, equation 12.4).
double sidereal_deg(double julian_day) {
  return wrapped(280.46061837 + 360.98564736629 * (julian_day - 2451545.0), 360);
}

// The digits at `text`'s front as a number; nullopt unless there are `digits` of them.
std::optional<int> take_number(std::string_view& text, std::size_t digits) {
  int value = 0;
  if (text.size() < digits) return std::nullopt;
  const auto [end, error] = std::from_chars(text.data(), text.data() + digits, value);
  if (error != std::errc() || end != text.data() + digits || text[0] == '-') return std::nullopt;
  text.remove_prefix(digits);
  return value;
}

bool take(std::string_view& text, char wanted) {
  if (text.empty() || text.front() != wanted) return false;
  text.remove_prefix(1);
  return true;
}

// "12:30", "12:30:30" or "12:30:30.5", in days; the text goes on behind it.
std::optional<double> take_time(std::string_view& text) {
  const auto hour = take_number(text, 2);
  if (!hour || *hour > 23 || !take(text, ':')) return std::nullopt;
  const auto minute = take_number(text, 2);
  if (!minute || *minute > 59) return std::nullopt;
  double second = 0;
  if (take(text, ':')) {
    const auto whole = take_number(text, 2);
    if (!whole || *whole > 59) return std::nullopt;
    second = *whole;
    if (take(text, '.')) {
      double place = 0.1;
      for (; !text.empty() && text.front() >= '0' && text.front() <= '9'; text.remove_prefix(1), place /= 10)
        second += place * (text.front() - '0');
    }
  }
  return (*hour + (*minute + second / 60) / 60) / 24;
}

int days_of_month(int year, int month) {
  constexpr int days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  return days[month - 1] + (month == 2 && year % 4 == 0 ? 1 : 0);  // 2000 was a leap year; 1900 and 2100 are outside
}

}  // namespace

std::optional<double> julian_day(std::string_view text) {
  const auto year = take_number(text, 4);
  if (!year || *year < 1901 || *year > 2099 || !take(text, '-')) return std::nullopt;
  const auto month = take_number(text, 2);
  if (!month || *month < 1 || *month > 12 || !take(text, '-')) return std::nullopt;
  const auto day = take_number(text, 2);
  if (!day || *day < 1 || *day > days_of_month(*year, *month) || !take(text, 'T')) return std::nullopt;
  const auto time = take_time(text);
  if (!time || text != "Z") return std::nullopt;
  // Meeus, equation 7.1, of the Gregorian calendar.
  const int y = *month <= 2 ? *year - 1 : *year, m = *month <= 2 ? *month + 12 : *month, century = y / 100;
  return std::floor(365.25 * (y + 4716)) + std::floor(30.6001 * (m + 1)) + *day + 2 - century + century / 4 - 1524.5 +
         *time;
}

double refraction_deg(double elevation) {
  if (elevation > 85) return 0;
  const double tangent = tan_deg(elevation);
  if (elevation > 5) return (58.1 / tangent - 0.07 / std::pow(tangent, 3) + 0.000086 / std::pow(tangent, 5)) / 3600;
  if (elevation > -0.575)
    return (1735 + elevation * (-518.2 + elevation * (103.4 + elevation * (-12.79 + elevation * 0.711)))) / 3600;
  return -20.772 / tangent / 3600;
}

HorizontalPosition sun_position(double day, double latitude_deg, double longitude_deg) {
  const double t = centuries_since_2000(day);
  const double mean_longitude = wrapped(280.46646 + t * (36000.76983 + t * 0.0003032), 360);
  const double anomaly = 357.52911 + t * (35999.05029 - 0.0001537 * t);
  const double eccentricity = 0.016708634 - t * (0.000042037 + 0.0000001267 * t);
  const double center = sin_deg(anomaly) * (1.914602 - t * (0.004817 + 0.000014 * t)) +
                        sin_deg(2 * anomaly) * (0.019993 - 0.000101 * t) + sin_deg(3 * anomaly) * 0.000289;
  const double node = 125.04 - 1934.136 * t;
  const double longitude = mean_longitude + center - 0.00569 - 0.00478 * sin_deg(node);
  const double obliquity = mean_obliquity_deg(t) + 0.00256 * cos_deg(node);
  const double declination = std::asin(sin_deg(obliquity) * sin_deg(longitude)) / radians_per_degree;
  const double y = tan_deg(obliquity / 2) * tan_deg(obliquity / 2);
  const double equation_of_time_deg =
      (y * sin_deg(2 * mean_longitude) - 2 * eccentricity * sin_deg(anomaly) +
       4 * eccentricity * y * sin_deg(anomaly) * cos_deg(2 * mean_longitude) -
       0.5 * y * y * sin_deg(4 * mean_longitude) - 1.25 * eccentricity * eccentricity * sin_deg(2 * anomaly)) /
      radians_per_degree;
  const double hour_angle = 360 * wrapped(day, 1) + equation_of_time_deg + longitude_deg;  // 0 at noon, as Julian days
  return seen(horizontal({hour_angle, declination}, latitude_deg));
}

EclipticPosition moon_ecliptic(double day) {
  const double t = centuries_since_2000(day);
  return {218.32 + 481267.881 * t + 6.29 * sin_deg(135.0 + 477198.87 * t) - 1.27 * sin_deg(259.3 - 413335.36 * t) +
              0.66 * sin_deg(235.7 + 890534.22 * t) + 0.21 * sin_deg(269.9 + 954397.74 * t) -
              0.19 * sin_deg(357.5 + 35999.05 * t) - 0.11 * sin_deg(186.5 + 966404.03 * t),
          5.13 * sin_deg(93.3 + 483202.02 * t) + 0.28 * sin_deg(228.2 + 960400.89 * t) -
              0.28 * sin_deg(318.3 + 6003.15 * t) - 0.17 * sin_deg(217.6 - 407332.21 * t),
          0.9508 + 0.0518 * cos_deg(135.0 + 477198.87 * t) + 0.0095 * cos_deg(259.3 - 413335.36 * t) +
              0.0078 * cos_deg(235.7 + 890534.22 * t) + 0.0028 * cos_deg(269.9 + 954397.74 * t)};
}

HorizontalPosition moon_position(double day, double latitude_deg, double longitude_deg) {
  const EclipticPosition moon = moon_ecliptic(day);
  const double obliquity = mean_obliquity_deg(centuries_since_2000(day));
  const double x = cos_deg(moon.latitude_deg) * cos_deg(moon.longitude_deg);
  const double along = cos_deg(moon.latitude_deg) * sin_deg(moon.longitude_deg), off = sin_deg(moon.latitude_deg);
  const double y = cos_deg(obliquity) * along - sin_deg(obliquity) * off;
  const double z = sin_deg(obliquity) * along + cos_deg(obliquity) * off;
  const double ascension = std::atan2(y, x) / radians_per_degree;
  const double hour_angle = sidereal_deg(day) + longitude_deg - ascension;
  HorizontalPosition position = horizontal({hour_angle, std::asin(z) / radians_per_degree}, latitude_deg);
  position.elevation_deg -= moon.parallax_deg * cos_deg(position.elevation_deg);
  return seen(position);
}

std::array<glm::dvec3, 3> star_axes(double day, double latitude_deg, double longitude_deg) {
  const double sidereal = sidereal_deg(day) + longitude_deg;
  const glm::dvec3 east(1, 0, 0), meridian(0, -sin_deg(latitude_deg), cos_deg(latitude_deg));
  return {cos_deg(sidereal) * meridian - sin_deg(sidereal) * east,
          sin_deg(sidereal) * meridian + cos_deg(sidereal) * east,
          glm::dvec3(0, cos_deg(latitude_deg), sin_deg(latitude_deg))};
}

std::optional<double> julian_day_at(const Place& place, double time_s) {
  constexpr double step_s = 4, day_s = 86400;
  const std::optional<double> day = julian_day(place.time_utc);
  if (!day) return day;
  return *day + step_s * std::round(place.time_rate * time_s / step_s) / day_s;
}

std::shared_ptr<const Cloudscape> at_time(const std::shared_ptr<const Cloudscape>& cloudscape, double time_s) {
  const Place& place = cloudscape->sun.place;
  if (place.time_rate * time_s == 0 || place.time_utc.empty()) return cloudscape;
  auto moved = std::make_shared<Cloudscape>(*cloudscape);
  place_sun_and_moon(*moved, time_s);
  return moved;
}

void place_sun_and_moon(Cloudscape& cloudscape, double time_s) {
  const Place& place = cloudscape.sun.place;
  const std::optional<double> day = julian_day_at(place, time_s);
  if (!day) return;
  const HorizontalPosition sun = sun_position(*day, place.latitude_deg, place.longitude_deg);
  const HorizontalPosition moon = moon_position(*day, place.latitude_deg, place.longitude_deg);
  cloudscape.sun.azimuth_deg = sun.azimuth_deg, cloudscape.sun.elevation_deg = sun.elevation_deg;
  cloudscape.moon.azimuth_deg = moon.azimuth_deg, cloudscape.moon.elevation_deg = moon.elevation_deg;
}

}  // namespace cloudscape
