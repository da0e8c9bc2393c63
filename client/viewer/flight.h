// The flight model: a pose and what the hands do become the next pose. World frame of core/view.h.
#pragma once
#include "core/view.h"

namespace cloudscape::viewer {

struct FlightInput {
  double forward = 0, right = 0, up = 0;       // -1..1: along the line of sight, level to its right, straight up
  double turn_right_deg = 0, turn_up_deg = 0;  // since the input before
  bool fast = false;
  bool operator==(const FlightInput&) const = default;
};

// Flies for `duration_s`. Full deflection, diagonal or not, moves at `speed_m_per_s`, and `fast_factor` times that when
// fast. The flight stops at the ground, unless it began below it, as it may where a document has no ground.
CameraPose fly(const CameraPose& pose, const FlightInput& input, double speed_m_per_s, double duration_s);

constexpr double fast_factor = 5.0;  // tuned: crosses a 12 km tile in seconds, yet can still be steered

// One notch of the wheel is a quarter faster or slower, within 1 m/s (walking) and 20 km/s (round the planet).
double change_speed(double speed_m_per_s, double notches);

// Metres above the round planet's surface (radius 6360 km).
double altitude_m(const glm::dvec3& position_m);

// What the mouse's way means, so that the point under it seems to stay under it: degrees a pixel of the window's
// height.
double degrees_per_pixel(const Lens& lens, int window_height_px);

// What a stick or trigger of -32768..32767 means in -1..1: nothing near its centre, where worn sticks rest.
double deflection(int axis_value);

}  // namespace cloudscape::viewer
