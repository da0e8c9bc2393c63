// What clients say: read, written, and refused with one sentence where it is wrong.
#include <random>

#include "tests/unit/settings/refusal.h"
#include "wire/messages.h"

namespace cloudscape::wire {
namespace {

using testing::HasSubstr;

template <class T>
T read_as(std::string_view text, const View& current = {}) {
  return std::get<T>(parse_client_message(text, current));
}
std::string sentence(std::string_view text) {
  return refusal([&] { parse_client_message(text); }).sentence;
}

TEST(ClientMessages, HelloCarriesEverySetting) {
  const Hello hello =
      read_as<Hello>(R"({"type": "hello", "version": 1, "cloudscape": "overcast", "size_px": [1280, 720],
    "pose": {"position_m": [1, 2, 3], "azimuth_deg": 4, "elevation_deg": 5, "roll_deg": 6},
    "lens": {"kind": "fisheye"}, "display": {"exposure_ev": 1, "tone_curve": "aces"}, "quality": "high",
    "sun_azimuth_deg": 100, "sun_elevation_deg": 20, "time_s": 30})");
  const Settings& settings = hello.settings;
  EXPECT_EQ(settings.cloudscape, "overcast");
  EXPECT_EQ(settings.size_px, (ImageSize{1280, 720}));
  EXPECT_EQ(settings.pose, (CameraPose{{1, 2, 3}, 4, 5, 6}));
  EXPECT_EQ(settings.lens->kind, LensKind::fisheye);
  EXPECT_EQ(settings.display, (Display{1, ToneCurve::aces, true}));
  EXPECT_EQ(settings.quality, Quality::high);
  EXPECT_EQ(settings.sun_azimuth_deg, 100);
  EXPECT_EQ(settings.sun_elevation_deg, 20);
  EXPECT_EQ(settings.time_s, 30);
  EXPECT_FALSE(settings.reset_sun);
}

TEST(ClientMessages, AbsentMembersStayAbsent) {
  const Settings settings = read_as<Settings>(R"({"type": "settings"})");
  EXPECT_FALSE(settings.cloudscape || settings.cloudscape_document || settings.size_px || settings.pose ||
               settings.lens || settings.display || settings.quality || settings.sun_azimuth_deg ||
               settings.sun_elevation_deg || settings.reset_sun || settings.time_s);
}

TEST(ClientMessages, MembersInPartAreCompletedFromTheCurrentView) {
  View current;
  current.display = {2, ToneCurve::reinhard, false};
  current.pose = {{7, 8, 9}, 10, 20, 0};
  const Settings settings = read_as<Settings>(R"({"type": "settings", "display": {"exposure_ev": 3}})", current);
  EXPECT_EQ(settings.display, (Display{3, ToneCurve::reinhard, false}));
  EXPECT_FALSE(settings.pose);
  EXPECT_EQ(read_as<Camera>(R"({"type": "camera", "pose": {"azimuth_deg": 30}})", current).pose,
            (CameraPose{{7, 8, 9}, 30, 20, 0}));
}

TEST(ClientMessages, NullResetsTheSunAndNothingElse) {
  const Settings settings =
      read_as<Settings>(R"({"type": "settings", "sun_azimuth_deg": null, "sun_elevation_deg": 5})");
  EXPECT_TRUE(settings.reset_sun);
  EXPECT_FALSE(settings.sun_azimuth_deg);
  EXPECT_EQ(settings.sun_elevation_deg, 5);
}

TEST(ClientMessages, ATimeOfNullFollowsTheClock) {
  const Settings settings = read_as<Settings>(R"({"type": "settings", "time_s": null})");
  EXPECT_TRUE(settings.follow_clock);
  EXPECT_FALSE(settings.time_s);
  EXPECT_FALSE(read_as<Settings>(R"({"type": "settings", "time_s": 0})").follow_clock);
}

TEST(ClientMessages, AClockIsTurnedInPart) {
  EXPECT_EQ(read_as<ClockChange>(R"({"type": "clock"})"), ClockChange{});
  EXPECT_EQ(read_as<ClockChange>(R"({"type": "clock", "paused": false, "rate": -60})"), (ClockChange{{}, -60, false}));
  EXPECT_EQ(read_as<ClockChange>(R"({"type": "clock", "time_s": 12.5})"), (ClockChange{12.5, {}, {}}));
  EXPECT_EQ(sentence(R"({"type": "clock", "rate": 3601})"), "/rate is 3601: must be within [-3600, 3600]");
  EXPECT_EQ(sentence(R"({"type": "clock", "time_s": 1.7e7})"),
            "/time_s is 17000000: must be within [-16000000, 16000000]");
  EXPECT_EQ(sentence(R"({"type": "clock", "paused": 1})"), "/paused is 1: must be true or false");
  EXPECT_THAT(sentence(R"({"type": "clock", "speed": 1})"), HasSubstr("/speed is not a known key"));
}

TEST(ClientMessages, AWholeDocumentIsCheckedAndHandedOn) {
  const Settings settings = read_as<Settings>(R"({"type": "settings", "cloudscape": {"seed": 5}})");
  EXPECT_FALSE(settings.cloudscape);
  EXPECT_EQ(settings.cloudscape_document, R"({"seed":5})");
  EXPECT_EQ(refusal([] { parse_client_message(R"({"type": "hello", "cloudscape": {"sky": {"haze": -1}}})"); }).pointer,
            "/cloudscape/sky/haze");
}

TEST(ClientMessages, CameraAndAck) {
  const Camera camera = read_as<Camera>(
      R"({"type":"camera","pose_sequence":18446744073709551615,"pose":{"position_m":[0,0,2],"azimuth_deg":-1},"time_s":4})");
  EXPECT_EQ(camera.pose_sequence, 18446744073709551615u);
  EXPECT_EQ(camera.pose.azimuth_deg, -1);
  EXPECT_EQ(camera.time_s, 4);
  const Ack ack = read_as<Ack>(R"({"type":"ack","frame_id":4294967295,"decode_ms":3.1})");
  EXPECT_EQ(ack.frame_id, 4294967295u);
  EXPECT_EQ(ack.decode_ms, 3.1);
}

TEST(ClientMessages, AreRefusedWithOneSentence) {
  EXPECT_EQ(sentence(R"({"pose": {}})"), "/type is missing");
  EXPECT_EQ(sentence(R"({"type": "helo"})"), R"(/type is "helo": must be one of hello, settings, camera, ack, clock)");
  EXPECT_EQ(sentence(R"({"type": 1})"), "/type is 1: must be one of hello, settings, camera, ack, clock");
  EXPECT_EQ(sentence("7"), "the document is 7: must be an object");
  EXPECT_THAT(sentence("{"), HasSubstr("the message: line 1, column 2"));
  EXPECT_EQ(sentence(R"({"type": "hello", "version": 2})"), "/version is 2: must be 1");
  EXPECT_THAT(sentence(R"({"type": "settings", "version": 1})"), HasSubstr("/version is not a known key"));
  EXPECT_EQ(sentence(R"({"type": "hello", "size": [1, 1]})"), "/size is not a known key: did you mean size_px?");
  EXPECT_EQ(sentence(R"({"type": "hello", "size_px": [0, 720]})"), "/size_px/0 is 0: must be within [1, 65535]");
  EXPECT_EQ(sentence(R"({"type": "hello", "size_px": [720]})"), "/size_px has 1 elements: must have 2");
  EXPECT_EQ(sentence(R"({"type": "hello", "sun_elevation_deg": 91})"),
            "/sun_elevation_deg is 91: must be within [-90, 90]");
  EXPECT_EQ(sentence(R"({"type": "camera"})"), "/pose is missing");
  EXPECT_EQ(sentence(R"({"type": "ack"})"), "/frame_id is missing");
  EXPECT_EQ(sentence(R"({"type": "ack", "frame_id": -1})"), "/frame_id is -1: must be within [0, 4294967295]");
  EXPECT_EQ(sentence(R"({"type": "camera", "pose": {"position_m": [0, 0, 1e400]}})").substr(0, 12), "the message:");
  EXPECT_THAT(sentence(R"({"type": "camera", "pose": {"azimuth_deg": NaN}})"), HasSubstr("syntax error"));
  EXPECT_EQ(sentence(R"({"type": "hello", "cloudscape": ")" + std::string(65, 'a') + "\"}"),
            "/cloudscape has 65 characters: must have at most 64");
  EXPECT_THAT(sentence(std::string(max_client_message_bytes + 1, ' ')), HasSubstr("at most 65536"));
}

std::vector<std::string> valid_messages() {
  Settings settings{
      "overcast", {},  ImageSize{640, 360}, CameraPose{}, Lens{}, Display{}, March{}, Quality::draft, 1.5, -2.0, false,
      60,         0.25};
  Settings reset;
  reset.reset_sun = true;
  reset.cloudscape_document = R"({"seed":3})";
  return {to_text(ClientMessage{Hello{1, settings}}),
          to_text(ClientMessage{settings}),
          to_text(ClientMessage{reset}),
          to_text(ClientMessage{Camera{9, CameraPose{{1, 2, 3}, 4, 5, 6}, 7.5}}),
          to_text(ClientMessage{ClockChange{600, -10, false}}),
          R"({"type":"settings","time_s":null})",
          to_text(ClientMessage{Ack{12, 3.1}})};
}

TEST(ClientMessages, AreWrittenAsTheyAreRead) {
  for (const std::string& text : valid_messages()) EXPECT_EQ(to_text(parse_client_message(text)), text);
  EXPECT_EQ(valid_messages().back(), R"({"type":"ack","frame_id":12,"decode_ms":3.1})");
}

TEST(ClientMessages, DamagedOnesAreRefusedOrReadAndNothingElse) {
  const auto whole = valid_messages();
  std::mt19937 random(7);
  int refused = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string text = whole[random() % whole.size()];
    const auto at = [&] { return random() % text.size(); };
    for (unsigned change = 0; change <= random() % 4; ++change) switch (random() % 4) {
        case 0:
          text[at()] = static_cast<char>(random());
          break;
        case 1:
          text.erase(at(), 1 + random() % 8);
          break;
        case 2:
          text.insert(at(), text.substr(at(), random() % 12));
          break;
        default:
          text[at()] = "{}[],:\"0-eE.\\"[random() % 13];
      }
    if (text.empty()) text = " ";
    try {
      parse_client_message(text);
    } catch (const InvalidInput& error) {
      ++refused;
      for (const char c : std::string(error.what())) ASSERT_TRUE(c >= 0x20 && c < 0x7F) << error.what();
    }
  }
  EXPECT_GT(refused, 10000);
}

}  // namespace
}  // namespace cloudscape::wire
