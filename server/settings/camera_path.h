// A flight that is described by keys in time, for recordings and benchmarks.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/view.h"
#include "settings/still_body.h"

namespace cloudscape {

enum class PathInterpolation { catmull_rom, bezier };
template <>
struct EnumNames<PathInterpolation> {
  static constexpr std::array<std::string_view, 2> names{"catmull-rom", "bezier"};
};

}  // namespace cloudscape

namespace cloudscape::settings {

struct CameraPath {
  struct Key {
    double time_s = 0;
    CameraPose pose;
    double vertical_fov_deg = 50;
    std::optional<glm::dvec3> in_m, out_m;
    bool operator==(const Key&) const = default;

    static void fields(auto& self, auto&& visit) {
      visit("time_s", self.time_s, time_s_limits, "When, s; each key later than the one before.");
      visit("pose", self.pose, Limits{}, "Where the camera is and looks.");
      visit("vertical_fov_deg", self.vertical_fov_deg, limits_of_fov(), "Vertical field of view, degrees.");
      visit(
          "in_m", self.in_m, Limits{-1e7, 1e7},
          "bezier: control point of the curve that arrives here, m; null: a third of the way back to the key before.");
      visit("out_m", self.out_m, Limits{-1e7, 1e7},
            "bezier: control point of the curve that leaves here, m; null: a third of the way to the key after.");
    }
  };
  struct Section {
    std::string name;
    double begin_s = 0, end_s = 0;
    bool operator==(const Section&) const = default;

    static void fields(auto& self, auto&& visit) {
      visit("name", self.name, Limits{1, 40}, "What the flight shows in this time.");
      visit("begin_s", self.begin_s, time_s_limits, "When it begins, s; not before the section before has ended.");
      visit("end_s", self.end_s, time_s_limits, "When it ends, s.");
    }
  };
  PathInterpolation interpolation = PathInterpolation::catmull_rom;
  std::vector<Key> keys;
  std::vector<Section> sections;
  bool operator==(const CameraPath&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("interpolation", self.interpolation, Limits{}, "How positions run from key to key.");
    visit("keys", self.keys, Limits{1, 10000}, "The camera at points in time.");
    visit("sections", self.sections, Limits{0, 100}, "Parts of the flight with a name, in order.");
  }

 private:
  static Limits limits_of_fov();  // Lens's own
};

// {"keys": [{"time_s": 0, "pose": {...}, "vertical_fov_deg": 50}, ...], "interpolation": "bezier", "sections":
// [{"name": "below", "begin_s": 0, "end_s": 15}, ...]}. Angles are unwound: a turn from 350 to 10 degrees goes through
// north. `source` opens messages about syntax. Throws InvalidInput.
CameraPath parse_camera_path(std::string_view text, const std::string& source);

// A path of config/paths, compiled into the program. Throws NotFound, with the nearest name.
CameraPath named_camera_path(std::string_view name);
// A file's path (it holds '/' or ends in .json), whose name opens the errors, or a name of config/paths. Throws
// NotFound, InvalidInput, Error (cannot be read).
CameraPath find_camera_path(const std::string& name_or_file);

// Before the first and after the last key, that key; the path must have one. The key that is returned has no control
// points.
//
// catmull_rom: a spline through the keys, which may be unevenly spaced. bezier: between two keys the cubic Bezier curve
// of their positions and the two control points between them, whose parameter is the share of the time between the
// keys: the camera leaves a key with the velocity 3 (out_m - position) / time to the next and arrives with
// 3 (position - in_m) / time from the last. Where control points are left out, it goes straight and evenly. Angles and
// field of view follow the spline in both.
CameraPath::Key key_at(const CameraPath& path, double time_s);
CameraPose at(const CameraPath& path, double time_s);

// The section that the moment is in, or none; where one ends and the next begins at once, the next.
const CameraPath::Section* section_at(const CameraPath& path, double time_s);

}  // namespace cloudscape::settings
