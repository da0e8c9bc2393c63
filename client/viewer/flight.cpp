// The flight model.
#include "viewer/flight.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace cloudscape::viewer {
namespace {

constexpr glm::dvec3 planet_center_m{0.0, 0.0, -6'360'000.0};
constexpr double eye_height_m = 1.7;
constexpr double farthest_m = 1e7;  // the limit of a pose's position, core/view.h

glm::dvec3 displacement_m(const CameraPose& pose, const FlightInput& input, double way_m) {
  const double azimuth = glm::radians(pose.azimuth_deg), elevation = glm::radians(pose.elevation_deg);
  const glm::dvec3 ahead{std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
                         std::sin(elevation)};
  const glm::dvec3 right{std::cos(azimuth), -std::sin(azimuth), 0.0};
  const glm::dvec3 deflection = ahead * input.forward + right * input.right + glm::dvec3{0, 0, 1} * input.up;
  const double length = glm::length(deflection);
  return deflection * (way_m / std::max(length, 1.0));
}

glm::dvec3 stop_at_ground(const glm::dvec3& from_m, const glm::dvec3& to_m) {
  if (altitude_m(from_m) < eye_height_m || altitude_m(to_m) >= eye_height_m) return to_m;
  const glm::dvec3 outward = glm::normalize(to_m - planet_center_m);
  return planet_center_m + outward * (-planet_center_m.z + eye_height_m);
}

}  // namespace

double altitude_m(const glm::dvec3& position_m) {
  return glm::length(position_m - planet_center_m) + planet_center_m.z;
}

CameraPose fly(const CameraPose& pose, const FlightInput& input, double speed_m_per_s, double duration_s) {
  CameraPose next = pose;
  next.azimuth_deg = std::fmod(pose.azimuth_deg + input.turn_right_deg, 360.0);
  if (next.azimuth_deg < 0) next.azimuth_deg += 360.0;
  next.elevation_deg = std::clamp(pose.elevation_deg + input.turn_up_deg, -90.0, 90.0);
  const double way_m = speed_m_per_s * (input.fast ? fast_factor : 1.0) * duration_s;
  const glm::dvec3 to_m = stop_at_ground(pose.position_m, pose.position_m + displacement_m(next, input, way_m));
  next.position_m = glm::clamp(to_m, -farthest_m, farthest_m);
  return next;
}

double change_speed(double speed_m_per_s, double notches) {
  return std::clamp(speed_m_per_s * std::pow(1.25, notches), 1.0, 20'000.0);
}

double degrees_per_pixel(const Lens& lens, int window_height_px) {
  const double height_deg = lens.kind == LensKind::perspective    ? lens.vertical_fov_deg
                            : lens.kind == LensKind::orthographic ? 45.0  // tuned: parallel rays give no scale
                                                                  : 180.0;
  return height_deg / std::max(window_height_px, 1);
}

double deflection(int axis_value) {
  constexpr double dead_zone = 0.2;  // XInput's XINPUT_GAMEPAD_LEFT_THUMB_DEADZONE is 0.24, of the right 0.27
  const double value = std::clamp(axis_value / 32767.0, -1.0, 1.0);
  return std::copysign(std::max(std::abs(value) - dead_zone, 0.0) / (1.0 - dead_zone), value);
}

}  // namespace cloudscape::viewer
