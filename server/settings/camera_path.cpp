// Camera paths: the curves between the keys.
#include "settings/camera_path.h"

#include <algorithm>
#include <cmath>

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
  return {
      time_s, {{n[0], n[1], n[2]}, n[3], std::clamp(n[4], -90.0, 90.0), n[5]}, std::clamp(n[6], 1.0, 170.0), {}, {}};
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

// The cubic Bezier curve from one key to the next (de Casteljau 1959) at `share` of the time between them.
glm::dvec3 bezier(const Key& from, const Key& to, double share) {
  const glm::dvec3 begin = from.pose.position_m, end = to.pose.position_m;
  const glm::dvec3 leaving = from.out_m.value_or((2.0 * begin + end) / 3.0);
  const glm::dvec3 arriving = to.in_m.value_or((begin + 2.0 * end) / 3.0);
  const double s = share, rest = 1 - share;
  return rest * rest * rest * begin + 3 * rest * rest * s * leaving + 3 * rest * s * s * arriving + s * s * s * end;
}

}  // namespace

Key key_at(const CameraPath& path, double time_s) {
  const auto& keys = path.keys;
  if (!(time_s > keys.front().time_s)) return key_of(keys.front().time_s, numbers_of(keys.front()));
  if (time_s >= keys.back().time_s) return key_of(keys.back().time_s, numbers_of(keys.back()));
  const auto after =
      std::upper_bound(keys.begin(), keys.end(), time_s, [](double time, const Key& key) { return time < key.time_s; });
  const auto second = static_cast<std::size_t>(after - keys.begin());
  const std::array<std::size_t, 4> around{second < 2 ? 0 : second - 2, second - 1, second,
                                          std::min(second + 1, keys.size() - 1)};
  std::array<double, 4> times{};
  std::array<std::array<double, 7>, 4> numbers{};
  for (std::size_t i = 0; i < 4; ++i) times[i] = keys[around[i]].time_s, numbers[i] = numbers_of(keys[around[i]]);
  const double share = (time_s - times[1]) / (times[2] - times[1]);
  std::array<double, 7> between{};
  for (std::size_t n = 0; n < between.size(); ++n)
    between[n] = spline({numbers[0][n], numbers[1][n], numbers[2][n], numbers[3][n]}, times, share);
  Key key = key_of(time_s, between);
  if (path.interpolation == PathInterpolation::bezier)
    key.pose.position_m = bezier(keys[second - 1], keys[second], share);
  return key;
}

CameraPose at(const CameraPath& path, double time_s) { return key_at(path, time_s).pose; }

const CameraPath::Section* section_at(const CameraPath& path, double time_s) {
  for (auto section = path.sections.rbegin(); section != path.sections.rend(); ++section)
    if (time_s >= section->begin_s && time_s <= section->end_s) return &*section;
  return nullptr;
}

}  // namespace cloudscape::settings
