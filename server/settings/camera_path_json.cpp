// Camera paths as documents: reading, checking, and finding by name.
#include <algorithm>
#include <cmath>

#include "settings/camera_path.h"
#include "settings/described_json.h"
#include "settings/named_documents.h"
#include "settings/text_file.h"

namespace cloudscape {
extern const EmbeddedFiles embedded_paths;
}

namespace cloudscape::settings {
namespace {

using Key = CameraPath::Key;

constexpr std::size_t max_path_bytes = 4 * 1024 * 1024;  // 10000 keys with every member

std::string element(const std::string& array, std::size_t index) { return array + "/" + std::to_string(index) + "/"; }

// The angle that is equal to `angle_deg` but for whole turns, and nearest to `to_deg`.
double unwound(double angle_deg, double to_deg) { return angle_deg + 360.0 * std::round((to_deg - angle_deg) / 360.0); }

void check_times(const CameraPath& path, const std::string& keys) {
  for (std::size_t i = 1; i < path.keys.size(); ++i)
    if (path.keys[i].time_s <= path.keys[i - 1].time_s)
      refuse(element(keys, i) + "time_s", path.keys[i].time_s,
             "more than the key's before, " + number_text(path.keys[i - 1].time_s));
}

// A control point that nothing would follow is a mistake.
void check_control_points(const CameraPath& path, const std::string& keys) {
  for (std::size_t i = 0; i < path.keys.size(); ++i) {
    const Key& key = path.keys[i];
    if (!key.in_m && !key.out_m) continue;
    if (path.interpolation != PathInterpolation::bezier)
      throw InvalidInput(element(keys, i) + (key.in_m ? "in_m" : "out_m"),
                         "is given: only a path whose /interpolation is \"bezier\" has control points");
    if (key.in_m && i == 0) throw InvalidInput(element(keys, i) + "in_m", "is given: nothing leads to the first key");
    if (key.out_m && i + 1 == path.keys.size())
      throw InvalidInput(element(keys, i) + "out_m", "is given: nothing follows the last key");
  }
}

void check_sections(const CameraPath& path, const std::string& sections) {
  double free_s = path.keys.front().time_s;
  const double last_s = path.keys.back().time_s;
  for (std::size_t i = 0; i < path.sections.size(); ++i) {
    const CameraPath::Section& section = path.sections[i];
    const auto before = path.sections.begin() + static_cast<std::ptrdiff_t>(i);
    if (section.name.empty()) throw InvalidInput(element(sections, i) + "name", "is missing: each section has one");
    if (std::any_of(path.sections.begin(), before, [&](const auto& other) { return other.name == section.name; }))
      refuse(element(sections, i) + "name", section.name, "a name that no section before has");
    if (section.begin_s < free_s)
      refuse(element(sections, i) + "begin_s", section.begin_s,
             std::string("at least the ") + (i == 0 ? "first key's time, " : "end of the section before, ") +
                 number_text(free_s));
    if (section.end_s <= section.begin_s)
      refuse(element(sections, i) + "end_s", section.end_s, "more than begin_s, " + number_text(section.begin_s));
    if (section.end_s > last_s)
      refuse(element(sections, i) + "end_s", section.end_s, "at most the last key's time, " + number_text(last_s));
    free_s = section.end_s;
  }
}

void unwind(CameraPath& path) {
  for (std::size_t i = 1; i < path.keys.size(); ++i) {
    CameraPose &pose = path.keys[i].pose, &before = path.keys[i - 1].pose;
    pose.azimuth_deg = unwound(pose.azimuth_deg, before.azimuth_deg);
    pose.roll_deg = unwound(pose.roll_deg, before.roll_deg);
  }
}

// `pointer` opens the errors' pointers.
CameraPath read_camera_path(const nlohmann::json& json, const std::string& pointer) {
  CameraPath path;
  read(json, path, pointer);
  if (path.keys.empty()) throw InvalidInput(pointer + "/keys", "is missing: must have at least 1 key");
  check_times(path, pointer + "/keys");
  check_control_points(path, pointer + "/keys");
  check_sections(path, pointer + "/sections");
  unwind(path);
  return path;
}

}  // namespace

Limits CameraPath::limits_of_fov() {
  Limits found;
  const Lens lens;
  Lens::fields(lens, [&](std::string_view name, const auto&, const Limits& limits, std::string_view) {
    if (name == "vertical_fov_deg") found = limits;
  });
  return found;
}

CameraPath parse_camera_path(std::string_view text, const std::string& source) {
  return read_camera_path(parse_json(text, source), "");
}

CameraPath named_camera_path(std::string_view name) {
  return parse_camera_path(named_document(embedded_paths, name, "camera path").bytes, std::string(name));
}

CameraPath find_camera_path(const std::string& name_or_file) {
  if (!is_file_path(name_or_file)) return named_camera_path(name_or_file);
  return read_camera_path(parse_json(read_text_file(name_or_file, max_path_bytes), name_or_file), name_or_file + "#");
}

}  // namespace cloudscape::settings
