// Sun, exposure and time under the keys.
#include "viewer/sight.h"

#include <algorithm>
#include <cmath>

namespace cloudscape::viewer {

Sight sight_of(const wire::Welcome& welcome) {
  Sight sight;
  sight.pose = welcome.pose;
  sight.lens = welcome.lens;
  sight.display = welcome.display;
  sight.sun_azimuth_deg = welcome.sun_azimuth_deg;
  sight.sun_elevation_deg = welcome.sun_elevation_deg;
  return sight;
}

std::optional<wire::Settings> adjust(Sight& sight, const Adjustment& adjustment, double duration_s) {
  wire::Settings settings;
  if (adjustment.sun_azimuth_deg != 0) {
    sight.sun_azimuth_deg = std::fmod(sight.sun_azimuth_deg + adjustment.sun_azimuth_deg * duration_s, 360.0);
    settings.sun_azimuth_deg = sight.sun_azimuth_deg;
  }
  if (adjustment.sun_elevation_deg != 0) {
    sight.sun_elevation_deg =
        std::clamp(sight.sun_elevation_deg + adjustment.sun_elevation_deg * duration_s, -90.0, 90.0);
    settings.sun_elevation_deg = sight.sun_elevation_deg;
  }
  if (adjustment.exposure_ev != 0) {
    sight.display.exposure_ev =
        std::clamp(sight.display.exposure_ev + adjustment.exposure_ev * duration_s, -20.0, 20.0);
    settings.display = sight.display;
  }
  const bool told = settings.sun_azimuth_deg || settings.sun_elevation_deg || settings.display;
  return told ? std::optional(settings) : std::nullopt;
}

std::optional<ClockChange> turned(double time_s, const Adjustment& adjustment, double duration_s) {
  if (adjustment.time_s == 0) return std::nullopt;
  return ClockChange{std::clamp(time_s + adjustment.time_s * duration_s, 0.0, longest_time_s), {}, {}};
}

}  // namespace cloudscape::viewer
