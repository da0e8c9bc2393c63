// The sections of a cloudscape around the medium: sun, moon, sky, ground, wind. Terrain and water have headers of their
// own.
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "core/cloudscape_terrain.h"
#include "core/cloudscape_water.h"
#include "core/fields.h"

namespace cloudscape {

// Where and when the sky is seen. While `time_utc` is not empty, sun and moon stand where they do there
// (core/sun_position.h).
struct Place {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  std::string time_utc;
  double time_rate = 0.0;
  bool operator==(const Place&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("latitude_deg", self.latitude_deg, Limits{-90, 90}, "Latitude, north positive, degrees.");
    visit("longitude_deg", self.longitude_deg, Limits{-180, 180}, "Longitude, east positive, degrees.");
    visit("time_utc", self.time_utc, Limits{0, 30},
          "Date and time, such as 2026-06-21T12:00:00Z, 1901 to 2099; sets the azimuth and elevation of sun and moon, "
          "and turns the stars. Empty: they stand where they are put.");
    visit(
        "time_rate", self.time_rate, Limits{-3600, 3600},
        "How fast the time here runs beside time_s, which counts from time_utc: 1: as fast, 60: a minute in a second. "
        "0: sun and moon stand still. Needs a time_utc.");
  }
};

struct Sun {
  double azimuth_deg = 135.0;
  double elevation_deg = 40.0;
  Place place;
  glm::dvec3 irradiance{1.983, 1.774, 1.74};
  double angular_radius_deg = 0.268;
  bool disc = true;
  bool operator==(const Sun&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("azimuth_deg", self.azimuth_deg, Limits{-360, 360}, "Where the sun stands, clockwise from north, degrees.");
    visit("elevation_deg", self.elevation_deg, Limits{-90, 90}, "Height of the sun above the horizon, degrees.");
    visit("place", self.place, Limits{}, "Place and time that the sun stands by, instead of by angles.");
    visit(
        "irradiance", self.irradiance, Limits{0, 1e6},
        "On a plane normal to the beam above the atmosphere (red, green, blue); the default is the sun's spectrum "
        "(ASTM G-173) in linear sRGB, of which 1, 1, 1 has the luminance of 1 W/m2/nm at all wavelengths. "
        "Radiance comes out in this unit per steradian. Without an atmosphere (sky none or uniform) it arrives whole.");
    visit("angular_radius_deg", self.angular_radius_deg, Limits{0.01, 10}, "Radius of the disc, degrees.");
    visit("disc", self.disc, Limits{}, "Whether the disc can be seen.");
  }
};

struct Moon {
  double azimuth_deg = 0.0;
  double elevation_deg = -90.0;
  double angular_radius_deg = 0.259;
  double brightness = 1.0;
  std::optional<double> phase_angle_deg;
  bool operator==(const Moon&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("azimuth_deg", self.azimuth_deg, Limits{-360, 360}, "Where the moon stands, clockwise from north, degrees.");
    visit("elevation_deg", self.elevation_deg, Limits{-90, 90}, "Height of the moon above the horizon, degrees.");
    visit("angular_radius_deg", self.angular_radius_deg, Limits{0.01, 10}, "Radius of the disc, degrees.");
    visit("brightness", self.brightness, Limits{0, 1e6},
          "Times the true brightness, which is 400,000 times less than the sun's at full moon; 0: no moon.");
    visit("phase_angle_deg", self.phase_angle_deg, Limits{0, 180},
          "0: full, 90: half, 180: new; null: as sun and moon stand to each other.");
  }
};

enum class SkyKind { none, uniform, clear };
template <>
struct EnumNames<SkyKind> {
  static constexpr std::array<std::string_view, 3> names{"none", "uniform", "clear"};
};

struct Sky {
  SkyKind kind = SkyKind::clear;
  glm::dvec3 radiance{0.1, 0.1, 0.1};
  double haze = 1.0;
  double aerosol_scale_m = 1200.0;
  double aerosol_asymmetry_g = 0.8;
  double rayleigh = 1.0;
  double ozone = 1.0;
  double stars = 1.0;
  bool operator==(const Sky&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("kind", self.kind, Limits{},
          "none: black. uniform: one radiance all round. clear: an atmosphere of air, aerosol and ozone (Hillaire "
          "2020).");
    visit("radiance", self.radiance, Limits{0, 1e6}, "Radiance of a uniform sky, the sun's unit per steradian.");
    visit("haze", self.haze, Limits{0, 20}, "Aerosol of a clear sky, times the clean continental amount.");
    visit("aerosol_scale_m", self.aerosol_scale_m, Limits{100, 20000},
          "Height in which the aerosol thins out to 1 / e, m.");
    visit("aerosol_asymmetry_g", self.aerosol_asymmetry_g, Limits{-0.95, 0.95},
          "Asymmetry of the aerosol's phase function (Cornette and Shanks 1992).");
    visit("rayleigh", self.rayleigh, Limits{0, 20}, "Air of a clear sky, times the earth's.");
    visit("ozone", self.ozone, Limits{0, 20}, "Ozone of a clear sky, times the earth's; it makes the twilight blue.");
    visit("stars", self.stars, Limits{0, 1e6},
          "Times the true brightness of the stars and of the night sky's own glow; 0: none.");
  }
};

enum class GroundKind { none, plain, terrain };
template <>
struct EnumNames<GroundKind> {
  static constexpr std::array<std::string_view, 3> names{"none", "plain", "terrain"};
};

struct Ground {
  GroundKind kind = GroundKind::plain;
  glm::dvec3 albedo{0.14, 0.15, 0.09};
  double variation = 0.5;
  Terrain terrain;
  Water water;
  bool operator==(const Ground&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit(
        "kind", self.kind, Limits{},
        "none: nothing below. plain: a curved diffuse surface at sea level, radius 6360 km. terrain: mountains on it.");
    visit("albedo", self.albedo, Limits{0, 1}, "Diffuse reflectance (red, green, blue).");
    visit("variation", self.variation, Limits{0, 1}, "How much the albedo changes from field to field; 0: not at all.");
    visit("terrain", self.terrain, Limits{}, "Heights and cover of a terrain (Olajos 2.4.1).");
    visit("water", self.water, Limits{}, "A sea, or lakes of a terrain, with any kind of ground.");
  }
};

struct Wind {
  double speed_m_per_s = 8.0;
  double towards_azimuth_deg = 60.0;
  double shear_per_s = 0.0;
  double evolution_m_per_s = 0.5;
  bool operator==(const Wind&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("speed_m_per_s", self.speed_m_per_s, Limits{0, 200},
          "How fast the wind blows at sea level, m/s; a layer drifts with the wind at its bottom.");
    visit("towards_azimuth_deg", self.towards_azimuth_deg, Limits{-360, 360},
          "Where it blows to, clockwise from north, degrees.");
    visit("shear_per_s", self.shear_per_s, Limits{-0.02, 0.02},
          "Change of its speed for each metre of altitude, 1/s; it also makes the clouds of a tiling noise lean. 0.001 "
          "is usual, 0.003 much.");
    visit("evolution_m_per_s", self.evolution_m_per_s, Limits{0, 20},
          "How fast the clouds' detail rises through them, m/s, by which they change as they drift; 0: they do not.");
  }
};

}  // namespace cloudscape
