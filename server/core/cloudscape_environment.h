// The sections of a cloudscape around the medium: sun, sky, ground, wind. The terrain has a header of its own.
#pragma once
#include <array>
#include <glm/vec3.hpp>

#include "core/cloudscape_terrain.h"
#include "core/fields.h"

namespace cloudscape {

struct Sun {
  double azimuth_deg = 135.0;
  double elevation_deg = 40.0;
  glm::dvec3 irradiance{1.474, 1.8504, 1.91198};
  double angular_radius_deg = 0.268;
  bool disc = true;
  bool operator==(const Sun&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("azimuth_deg", self.azimuth_deg, Limits{-360, 360}, "Where the sun stands, clockwise from north, degrees.");
    visit("elevation_deg", self.elevation_deg, Limits{-90, 90}, "Height of the sun above the horizon, degrees.");
    visit(
        "irradiance", self.irradiance, Limits{0, 1e6},
        "On a plane normal to the beam above the atmosphere (red, green, blue); the default is solar, W/m2/nm "
        "(Bruneton 2017). "
        "Radiance comes out in this unit per steradian. Without an atmosphere (sky none or uniform) it arrives whole.");
    visit("angular_radius_deg", self.angular_radius_deg, Limits{0.01, 10}, "Radius of the disc, degrees.");
    visit("disc", self.disc, Limits{}, "Whether the disc can be seen.");
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
  bool operator==(const Sky&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("kind", self.kind, Limits{},
          "none: black. uniform: one radiance all round. clear: an atmosphere of air and haze.");
    visit("radiance", self.radiance, Limits{0, 1e6}, "Radiance of a uniform sky, the sun's unit per steradian.");
    visit("haze", self.haze, Limits{0, 20}, "Aerosol of a clear sky, times the clean continental amount.");
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
  bool operator==(const Ground&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit(
        "kind", self.kind, Limits{},
        "none: nothing below. plain: a curved diffuse surface at sea level, radius 6360 km. terrain: mountains on it.");
    visit("albedo", self.albedo, Limits{0, 1}, "Diffuse reflectance (red, green, blue).");
    visit("variation", self.variation, Limits{0, 1}, "How much the albedo changes from field to field; 0: not at all.");
    visit("terrain", self.terrain, Limits{}, "Heights and cover of a terrain (Olajos 2.4.1).");
  }
};

struct Wind {
  double speed_m_per_s = 8.0;
  double towards_azimuth_deg = 60.0;
  bool operator==(const Wind&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("speed_m_per_s", self.speed_m_per_s, Limits{0, 200}, "How fast the clouds drift, m/s.");
    visit("towards_azimuth_deg", self.towards_azimuth_deg, Limits{-360, 360},
          "Where they drift to, clockwise from north, degrees.");
  }
};

}  // namespace cloudscape
