// Camera paths: the spline goes through its keys, smoothly, the short way round.
#include <cmath>
#include <map>

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

std::string sentence(const std::string& text) {
  return refusal([&] { parse_camera_path(text, "path.json"); }).sentence;
}

TEST(CameraPath, RefusesWhatIsNoPath) {
  EXPECT_EQ(sentence("{}"), "/keys is missing: must have at least 1 key");
  EXPECT_EQ(sentence(R"({"keys": []})"), "/keys has 0 elements: must have at least 1");
  EXPECT_EQ(sentence(R"({"keys": [{"time_s": 1}, {"time_s": 1}]})"),
            "/keys/1/time_s is 1: must be more than the key's before, 1");
  EXPECT_EQ(sentence(R"({"keys": [{"vertical_fov_deg": 200}]})"),
            "/keys/0/vertical_fov_deg is 200: must be within [1, 170]");
  EXPECT_EQ(sentence(R"({"keys": [{}], "interpolation": "cubic"})"),
            "/interpolation is \"cubic\": must be one of catmull-rom, bezier");
  EXPECT_EQ(sentence("{\"keys\": [\n{]}").substr(0, 9), "path.json");
}

CameraPath bezier_path(const std::string& keys) {
  return parse_camera_path(R"({"interpolation": "bezier", "keys": [)" + keys + "]}", "path.json");
}
std::string bezier_key(double time_s, const std::string& position, const std::string& controls = "") {
  return R"({"time_s": )" + std::to_string(time_s) + R"(, "pose": {"position_m": )" + position + "}" + controls + "}";
}

void expect_near(const glm::dvec3& found, const glm::dvec3& right, double error) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(found[axis], right[axis], error) << "axis " << axis;
}

TEST(BezierPath, BetweenKeysIsTheBernsteinPolynomial) {
  const CameraPath path = bezier_path(bezier_key(2, "[1, 2, 3]", R"(, "out_m": [4, -8, 12])") + "," +
                                      bezier_key(7, "[20, 0, 5]", R"(, "in_m": [10, 6, 1])"));
  const glm::dvec3 p0{1, 2, 3}, p1{4, -8, 12}, p2{10, 6, 1}, p3{20, 0, 5};
  for (int i = 0; i <= 10; ++i) {
    const double s = i / 10.0, r = 1 - s;
    expect_near(at(path, 2 + 5 * s).position_m,
                r * r * r * p0 + 3 * r * r * s * p1 + 3 * r * s * s * p2 + s * s * s * p3, 1e-9);
  }
}

TEST(BezierPath, LeavesAndArrivesAlongItsControlPoints) {
  const CameraPath path =
      bezier_path(bezier_key(0, "[0, 0, 0]", R"(, "out_m": [30, 0, 0])") + "," +
                  bezier_key(10, "[100, 50, 0]", R"(, "in_m": [100, 20, 0], "out_m": [100, 65, 0])") + "," +
                  bezier_key(15, "[0, 0, 9]"));
  constexpr double h = 1e-6;
  const auto velocity = [&](double time_s) {
    return (at(path, time_s + h).position_m - at(path, time_s - h).position_m) / (2 * h);
  };
  expect_near(velocity(2 * h), {9, 0, 0}, 1e-4);       // 3 (30 - 0) / 10 s
  expect_near(velocity(10 - 2 * h), {0, 9, 0}, 1e-4);  // 3 (50 - 20) / 10 s
  expect_near(velocity(10 + 2 * h), {0, 9, 0}, 1e-4);  // 3 (65 - 50) / 5 s: no jump, and no corner
}

TEST(BezierPath, WithoutControlPointsIsStraightAndEven) {
  const CameraPath path =
      bezier_path(bezier_key(0, "[0, 0, 0]") + "," + bezier_key(1, "[10, 20, 30]") + "," + bezier_key(5, "[0, 0, 0]"));
  for (int i = 0; i <= 100; ++i) {
    const double share = i / 100.0;
    expect_near(at(path, share).position_m, share * glm::dvec3(10, 20, 30), 1e-9);
    expect_near(at(path, 1 + 4 * share).position_m, (1 - share) * glm::dvec3(10, 20, 30), 1e-9);
  }
}

TEST(BezierPath, ControlPointsOnALineKeepItStraight) {
  const CameraPath path = bezier_path(bezier_key(0, "[0, 0, 0]", R"(, "out_m": [1, 2, 3])") + "," +
                                      bezier_key(4, "[10, 20, 30]", R"(, "in_m": [9, 18, 27])"));
  for (double time_s = 0; time_s <= 4; time_s += 0.1) {
    const glm::dvec3 position_m = at(path, time_s).position_m;
    expect_near(position_m, position_m.x * glm::dvec3(1, 2, 3), 1e-9);
  }
}

TEST(BezierPath, GoesThroughItsKeysAndTurnsAsTheSplineDoes) {
  const std::string keys = key(0, R"("position_m": [0, 0, 5], "azimuth_deg": 350)") + "," +
                           key(2, R"("position_m": [7, 1, 9], "azimuth_deg": 20)") + "," +
                           key(5, R"("position_m": [-3, 2, 0], "elevation_deg": 80)");
  const CameraPath path = bezier_path(keys), spline = path_of(keys);
  for (const auto& at_key : path.keys) EXPECT_EQ(key_at(path, at_key.time_s), at_key);
  for (double time_s = -1; time_s < 6; time_s += 0.1) {
    EXPECT_EQ(at(path, time_s).azimuth_deg, at(spline, time_s).azimuth_deg);
    EXPECT_EQ(at(path, time_s).elevation_deg, at(spline, time_s).elevation_deg);
  }
}

TEST(BezierPath, RefusesControlPointsThatNothingFollows) {
  const std::string keys = R"("keys": [{"time_s": 0, "out_m": [1, 2, 3]}, {"time_s": 1}])";
  EXPECT_EQ(sentence("{" + keys + "}"),
            "/keys/0/out_m is given: only a path whose /interpolation is \"bezier\" has control points");
  EXPECT_EQ(sentence(R"({"interpolation": "bezier", "keys": [{"in_m": [1, 2, 3]}]})"),
            "/keys/0/in_m is given: nothing leads to the first key");
  EXPECT_EQ(sentence(R"({"interpolation": "bezier", "keys": [{"out_m": [1, 2, 3]}]})"),
            "/keys/0/out_m is given: nothing follows the last key");
  EXPECT_EQ(sentence(R"({"interpolation": "bezier", "keys": [{}, {"time_s": 1, "in_m": [1, 2]}]})"),
            "/keys/1/in_m has 2 elements: must have 3");
}

std::string with_sections(const std::string& sections) {
  return R"({"keys": [{"time_s": 0}, {"time_s": 20}], "sections": [)" + sections + "]}";
}

TEST(PathSections, HaveTheTimesOfTheirs) {
  const CameraPath path = parse_camera_path(
      with_sections(R"({"name": "below", "begin_s": 1, "end_s": 5}, {"name": "inside", "begin_s": 5, "end_s": 9},)"
                    R"({"name": "above", "begin_s": 12, "end_s": 20})"),
      "path.json");
  const auto name_at = [&](double time_s) {
    const auto* section = section_at(path, time_s);
    return section ? section->name : "";
  };
  EXPECT_EQ(name_at(0), "");
  EXPECT_EQ(name_at(1), "below");
  EXPECT_EQ(name_at(4.9), "below");
  EXPECT_EQ(name_at(5), "inside");
  EXPECT_EQ(name_at(10), "");
  EXPECT_EQ(name_at(20), "above");
  EXPECT_EQ(name_at(21), "");
}

TEST(PathSections, AreRefusedWhereTheyContradictThePath) {
  EXPECT_EQ(sentence(with_sections(R"({"begin_s": 0, "end_s": 5})")),
            "/sections/0/name is missing: each section has one");
  EXPECT_EQ(sentence(with_sections(R"({"name": "a", "begin_s": -1, "end_s": 5})")),
            "/sections/0/begin_s is -1: must be at least the first key's time, 0");
  EXPECT_EQ(sentence(with_sections(R"({"name": "a", "begin_s": 3, "end_s": 3})")),
            "/sections/0/end_s is 3: must be more than begin_s, 3");
  EXPECT_EQ(sentence(with_sections(R"({"name": "a", "begin_s": 3, "end_s": 21})")),
            "/sections/0/end_s is 21: must be at most the last key's time, 20");
  EXPECT_EQ(sentence(with_sections(R"({"name": "a", "end_s": 5}, {"name": "b", "begin_s": 4, "end_s": 9})")),
            "/sections/1/begin_s is 4: must be at least the end of the section before, 5");
  EXPECT_EQ(sentence(with_sections(R"({"name": "a", "end_s": 5}, {"name": "a", "begin_s": 5, "end_s": 9})")),
            "/sections/1/name is \"a\": must be a name that no section before has");
  EXPECT_EQ(sentence(with_sections(R"({"name": "a", "end": 5})")).substr(0, 15), "/sections/0/end");
}

// The towers of the sky that the track is made for (east, north; repeated every 8 km) and the layer's base, m.
constexpr double towers_m[3][2] = {{2400, 4800}, {5760, 2400}, {5200, 6240}};
constexpr double base_m = 900, top_m = 3400;

double nearest_tower_m(const glm::dvec3& position_m) {
  double nearest_m = 1e9;
  for (const auto& tower : towers_m)
    nearest_m = std::min(nearest_m, std::hypot(std::remainder(position_m.x - tower[0], 8000),
                                               std::remainder(position_m.y - tower[1], 8000)));
  return nearest_m;
}

TEST(TestTrack, ShowsInEachSectionWhatItsNameSays) {
  const CameraPath path = find_camera_path("test-track");
  std::map<std::string, int> frames;
  for (double time_s = path.keys.front().time_s; time_s < path.keys.back().time_s; time_s += 0.1) {
    const auto* section = section_at(path, time_s);
    if (!section) continue;
    ++frames[section->name];
    const CameraPose pose = at(path, time_s);
    const double altitude_m = pose.position_m.z, tower_m = nearest_tower_m(pose.position_m);
    if (section->name == "below") {
      EXPECT_TRUE(altitude_m < base_m && pose.elevation_deg > 10) << time_s;
    } else if (section->name == "inside") {
      EXPECT_TRUE(altitude_m > base_m && altitude_m < top_m && tower_m < 400) << time_s;
    } else if (section->name == "above") {
      EXPECT_TRUE(altitude_m > top_m - 100 && pose.elevation_deg < -15) << time_s;
    } else {
      EXPECT_GT(tower_m, 2500) << time_s;
    }
  }
  ASSERT_EQ(frames.size(), 4u);
  for (const auto& [name, count] : frames) EXPECT_GE(count, 140) << name;
  EXPECT_EQ(section_at(path, 60)->name, "beside, far away");
}

TEST(NamedPath, IsFoundByNameOrByFile) {
  EXPECT_EQ(find_camera_path("fly-around"), find_camera_path(CLOUDSCAPE_SOURCE_DIR "/config/paths/fly-around.json"));
  const std::string unknown = refusal<NotFound>([] { find_camera_path("fly-arund"); }).sentence;
  EXPECT_EQ(unknown, "there is no camera path \"fly-arund\": did you mean fly-around?");
  EXPECT_NE(refusal<Error>([] { find_camera_path("nowhere/path.json"); }).sentence.find("nowhere/path.json"),
            std::string::npos);
  const std::string file = testing::TempDir() + "bad-path.json";
  write_text_file(file, R"({"keys": [{"time_s": 1}, {"time_s": 0}]})");
  EXPECT_EQ(refusal([&] { find_camera_path(file); }).sentence,
            file + "#/keys/1/time_s is 0: must be more than the key's before, 1");
}

}  // namespace
}  // namespace cloudscape::settings
