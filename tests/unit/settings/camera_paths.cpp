// Camera paths: the spline goes through its keys, smoothly, the short way round.
#include <cmath>

#include "settings/camera_path.h"
#include "settings/text_file.h"
#include "tests/unit/settings/refusal.h"

namespace cloudscape::settings {
namespace {

CameraPath path_of(const std::string& keys) { return parse_camera_path("{\"keys\": [" + keys + "]}", "path.json"); }
std::string key(double time_s, const std::string& pose) {
  return R"({"time_s": )" + std::to_string(time_s) + R"(, "pose": {)" + pose + "}}";
}

TEST(CameraPath, GoesThroughItsKeysAndStaysAtItsEnds) {
  const CameraPath path = path_of(key(1, R"("position_m": [0, 0, 5])") + "," + key(2, R"("position_m": [7, 1, 9])") +
                                  "," + key(5, R"("position_m": [-3, 2, 0], "elevation_deg": 80)"));
  for (const auto& at_key : path.keys) EXPECT_EQ(key_at(path, at_key.time_s), at_key);
  EXPECT_EQ(at(path, -100), path.keys.front().pose);
  EXPECT_EQ(at(path, 100), path.keys.back().pose);
  EXPECT_EQ(at(path, NAN), path.keys.front().pose);
}

// Catmull-Rom reproduces straight motion, unevenly spaced keys included.
TEST(CameraPath, EvenMotionStaysEven) {
  std::string keys;
  for (const double time_s : {0.0, 1.0, 1.5, 4.0, 6.0})
    keys += (keys.empty() ? "" : ",") + key(time_s, "\"position_m\": [" + std::to_string(10 * time_s) +
                                                        ", 0, 0], \"azimuth_deg\": " + std::to_string(30 * time_s));
  const CameraPath path = path_of(keys);
  for (double time_s = 0; time_s <= 6; time_s += 0.01) {
    EXPECT_NEAR(at(path, time_s).position_m.x, 10 * time_s, 1e-9);
    EXPECT_NEAR(at(path, time_s).azimuth_deg, 30 * time_s, 1e-9);
  }
}

TEST(CameraPath, TurnsTheShortWayThroughNorth) {
  const CameraPath path = path_of(key(0, R"("azimuth_deg": 350)") + "," + key(1, R"("azimuth_deg": 10)") + "," +
                                  key(2, R"("azimuth_deg": -330)"));
  EXPECT_NEAR(at(path, 0.5).azimuth_deg, 360, 1e-9);
  EXPECT_NEAR(at(path, 1.5).azimuth_deg, 380, 1e-9);
}

TEST(CameraPath, SpeedDoesNotJumpAtKeys) {
  const CameraPath path =
      parse_camera_path(read_text_file(CLOUDSCAPE_SOURCE_DIR "/config/paths/fly-around.json", 1 << 20), "fly-around");
  constexpr double h = 1e-4;
  for (std::size_t i = 1; i + 1 < path.keys.size(); ++i) {
    const double time_s = path.keys[i].time_s;
    const glm::dvec3 before = (at(path, time_s).position_m - at(path, time_s - h).position_m) / h;
    const glm::dvec3 after = (at(path, time_s + h).position_m - at(path, time_s).position_m) / h;
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(before[axis], after[axis], 0.2) << "m/s at key " << i;
  }
}

TEST(CameraPath, TheExampleFliesFromBelowThroughTheLayerToAbove) {
  const CameraPath path =
      parse_camera_path(read_text_file(CLOUDSCAPE_SOURCE_DIR "/config/paths/fly-around.json", 1 << 20), "fly-around");
  EXPECT_EQ(path.keys.back().time_s - path.keys.front().time_s, 20);
  EXPECT_LT(at(path, 0).position_m.z, 1000);
  EXPECT_GT(at(path, 10).position_m.z, 1000);
  EXPECT_LT(at(path, 10).position_m.z, 2800);
  EXPECT_GT(at(path, 20).position_m.z, 2800);
  for (double time_s = 0; time_s < 20; time_s += 0.1)
    EXPECT_LT(std::abs(at(path, time_s + 0.1).azimuth_deg - at(path, time_s).azimuth_deg), 3.0) << time_s;
}

TEST(CameraPath, KeepsAnglesThatOvershootWithinTheirBounds) {
  const CameraPath path = path_of(key(0, R"("elevation_deg": 0)") + "," + key(1, R"("elevation_deg": 90)") + "," +
                                  key(2, R"("elevation_deg": 90)") + "," + key(3, R"("elevation_deg": 0)"));
  for (double time_s = 0; time_s < 3; time_s += 0.01) EXPECT_LE(at(path, time_s).elevation_deg, 90);
}

TEST(CameraPath, RefusesWhatIsNoPath) {
  const auto sentence = [](const std::string& text) {
    return refusal([&] { parse_camera_path(text, "path.json"); }).sentence;
  };
  EXPECT_EQ(sentence("{}"), "/keys is missing: must have at least 1 key");
  EXPECT_EQ(sentence(R"({"keys": []})"), "/keys has 0 elements: must have at least 1");
  EXPECT_EQ(sentence(R"({"keys": [{"time_s": 1}, {"time_s": 1}]})"),
            "/keys/1/time_s is 1: must be more than the key's before, 1");
  EXPECT_EQ(sentence(R"({"keys": [{"vertical_fov_deg": 200}]})"),
            "/keys/0/vertical_fov_deg is 200: must be within [1, 170]");
}

}  // namespace
}  // namespace cloudscape::settings
