// Camera paths: reading, and the spline between the keys.
#include "settings/camera_path.h"

#include <algorithm>
#include <cmath>

#include "settings/described_json.h"

namespace cloudscape::settings {
namespace {

using Key = CameraPath::Key;

// The numbers of a key that the spline runs through.
std::array<double, 7> numbers_of(const Key& key) {
  const CameraPose& pose = key.pose;
  return {pose.position_m.x,  pose.position_m.y, pose.position_m.z,   pose.azimuth_deg,
          pose.elevation_deg, pose.roll_deg,     key.vertical_fov_deg};
}

Key key_of(double time_s, const std::array<double, 7>& n) {
  // The spline may swing past its keys: what has bounds is kept in them.
  return {time_s, {{n[0], n[1], n[2]}, n[3], std::clamp(n[4], -90.0, 90.0), n[5]}, std::clamp(n[6], 1.0, 170.0)};
}

// The angle that is equal to `angle_deg` but for whole turns, and nearest to `to_deg`.
double unwound(double angle_deg, double to_deg) { return angle_deg + 360.0 * std::round((to_deg - angle_deg) / 360.0); }

void check_times(const CameraPath& path) {
  for (std::size_t i = 1; i < path.keys.size(); ++i)
    if (path.keys[i].time_s <= path.keys[i - 1].time_s)
      refuse("/keys/" + std::to_string(i) + "/time_s", path.keys[i].time_s,
             "more than the key's before, " + number_text(path.keys[i - 1].time_s));
}

void unwind(CameraPath& path) {
  for (std::size_t i = 1; i < path.keys.size(); ++i) {
    CameraPose &pose = path.keys[i].pose, &before = path.keys[i - 1].pose;
    pose.azimuth_deg = unwound(pose.azimuth_deg, before.azimuth_deg);
    pose.roll_deg = unwound(pose.roll_deg, before.roll_deg);
  }
}

// Cubic Hermite interpolation at `share` of the interval from p1 to p2, which lasts `span_s`. The slope at a key is
// that of the line through its two neighbours, which for even spacing is Catmull and Rom 1974; at an end of the path
// the key stands for its missing neighbour.
double spline(const std::array<double, 4>& p, const std::array<double, 4>& t, double share) {
  const double span_s = t[2] - t[1];
  const double slope_1 = (p[2] - p[0]) / (t[2] - t[0]) * span_s, slope_2 = (p[3] - p[1]) / (t[3] - t[1]) * span_s;
  const double s = share, s2 = s * s, s3 = s2 * s;
  return (2 * s3 - 3 * s2 + 1) * p[1] + (s3 - 2 * s2 + s) * slope_1 + (3 * s2 - 2 * s3) * p[2] + (s3 - s2) * slope_2;
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
  CameraPath path;
  const nlohmann::json json = parse_json(text, source);
  read(json, path, "");
  if (path.keys.empty()) throw InvalidInput("/keys", "is missing: must have at least 1 key");
  check_times(path);
  unwind(path);
  return path;
}

Key key_at(const CameraPath& path, double time_s) {
  const auto& keys = path.keys;
  if (!(time_s > keys.front().time_s)) return keys.front();
  if (time_s >= keys.back().time_s) return keys.back();
  const auto after =
      std::upper_bound(keys.begin(), keys.end(), time_s, [](double time, const Key& key) { return time < key.time_s; });
  const auto second = static_cast<std::size_t>(after - keys.begin());
  const std::array<std::size_t, 4> around{second < 2 ? 0 : second - 2, second - 1, second,
                                          std::min(second + 1, keys.size() - 1)};
  std::array<double, 4> times{};
  std::array<std::array<double, 7>, 4> numbers{};
  for (std::size_t i = 0; i < 4; ++i) times[i] = keys[around[i]].time_s, numbers[i] = numbers_of(keys[around[i]]);
  std::array<double, 7> between{};
  for (std::size_t n = 0; n < between.size(); ++n)
    between[n] = spline({numbers[0][n], numbers[1][n], numbers[2][n], numbers[3][n]}, times,
                        (time_s - times[1]) / (times[2] - times[1]));
  return key_of(time_s, between);
}

CameraPose at(const CameraPath& path, double time_s) { return key_at(path, time_s).pose; }

}  // namespace cloudscape::settings
