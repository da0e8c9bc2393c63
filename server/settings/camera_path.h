// A flight that is described by keys in time, for recordings and benchmarks.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/view.h"
#include "settings/still_body.h"

namespace cloudscape::settings {

struct CameraPath {
  struct Key {
    double time_s = 0;
    CameraPose pose;
    double vertical_fov_deg = 50;
    bool operator==(const Key&) const = default;

    static void fields(auto& self, auto&& visit) {
      visit("time_s", self.time_s, time_s_limits, "When, s; each key later than the one before.");
      visit("pose", self.pose, Limits{}, "Where the camera is and looks.");
      visit("vertical_fov_deg", self.vertical_fov_deg, limits_of_fov(), "Vertical field of view, degrees.");
    }
  };
  std::vector<Key> keys;
  bool operator==(const CameraPath&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("keys", self.keys, Limits{1, 10000}, "The camera at points in time.");
  }

 private:
  static Limits limits_of_fov();  // Lens's own
};

// {"keys": [{"time_s": 0, "pose": {...}, "vertical_fov_deg": 50}, ...]}. Angles are unwound: a turn from 350 to 10
// degrees goes through north. Throws InvalidInput.
CameraPath parse_camera_path(std::string_view text, const std::string& source);

// A Catmull-Rom spline through the keys, which may be unevenly spaced; before the first and after the last key, that
// key. The path must have one.
CameraPath::Key key_at(const CameraPath& path, double time_s);
CameraPose at(const CameraPath& path, double time_s);

}  // namespace cloudscape::settings
