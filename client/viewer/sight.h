// What the person looks at and under which light: the client's own truth once the server has said where it starts.
#pragma once
#include <optional>

#include "viewer/flight.h"
#include "wire/messages.h"

namespace cloudscape::viewer {

struct Sight {
  CameraPose pose;
  Lens lens;
  Display display;
  double sun_azimuth_deg = 0, sun_elevation_deg = 0;
  double speed_m_per_s = 200;  // tuned: crosses a cumulus in a few seconds
};

// How fast held keys change the picture; units a second.
struct Adjustment {
  double sun_azimuth_deg = 0, sun_elevation_deg = 0, exposure_ev = 0, time_s = 0;
  bool operator==(const Adjustment&) const = default;
};

Sight sight_of(const wire::Welcome& welcome);

// Changes the sight by what is held for `duration_s`; returns what the server must be told beside the pose.
std::optional<wire::Settings> adjust(Sight& sight, const Adjustment& adjustment, double duration_s);

// What the document's clock is turned to by keys that are held for `duration_s`, where it shows `time_s` now.
std::optional<ClockChange> turned(double time_s, const Adjustment& adjustment, double duration_s);

}  // namespace cloudscape::viewer
