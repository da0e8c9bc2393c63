// The clear sky with its atmosphere traced: documents, what is seen in a direction, and the Monte Carlo tracer's
// answer.
#pragma once
#include <cstdio>
#include <string>

#include "gpu/render/traced_air.h"
#include "render/block_values.h"
#include "traced.h"

namespace cloudscape::render {

struct Look {
  double altitude_m, azimuth_deg, elevation_deg;
};

// Red, green and blue, with the standard error of each.
struct Colours {
  glm::dvec3 mean{0}, error{0};
};

inline Colours colours_of(const Frame& frame) {
  Colours colours;
  for (std::size_t i = 0; i < 3; ++i) {
    const Measured m = measured(frame, i);
    colours.mean[static_cast<int>(i)] = m.mean, colours.error[static_cast<int>(i)] = m.error;
  }
  return colours;
}

inline FrameRequest through_air(FrameRequest request) {
  request.tracing.atmosphere = TracedAtmosphere::traced;
  return request;
}

inline CameraPose pose_of(const Look& look) {
  return {{0, 0, look.altitude_m}, look.azimuth_deg, look.elevation_deg, 0};
}

inline Colours seen(const Cloudscape& sky, const Look& look, int side, int samples) {
  return colours_of(TraceTest::traced(through_air(traced_beam(sky, pose_of(look), side, samples))));
}

inline glm::dvec3 by_tables(const Cloudscape& sky, const Look& look) {
  const Frame frame = TraceTest::traced(one_ray(sky, pose_of(look)));
  return {frame.radiance_rgba[0], frame.radiance_rgba[1], frame.radiance_rgba[2]};
}

inline TracedRadiance by_photons(double sun_deg, double albedo, const Look& look, int paths) {
  return traced_sky({.sun = direction_of(0, sun_deg), .albedo = albedo}, look.altitude_m,
                    direction_of(look.azimuth_deg, look.elevation_deg), paths);
}

inline std::string name_of(double sun_deg, const Look& look) {
  char text[100];
  std::snprintf(text, sizeof text, "sun %.0f, from %.0f m, azimuth %.0f, elevation %.0f", sun_deg, look.altitude_m,
                look.azimuth_deg, look.elevation_deg);
  return text;
}

// Up and down, towards the sun and away from it: what the air's light, its aerosol's peak and the ground take part in.
constexpr Look looks[] = {{2, 90, 90}, {2, 0, 30},      {2, 180, 45},    {2, 90, 10},     {2, 180, 2},
                          {2, 10, 2},  {3000, 90, -80}, {3000, 180, -6}, {12000, 0, -20}, {12000, 90, 5}};

}  // namespace cloudscape::render
