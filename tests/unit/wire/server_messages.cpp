// What the server says: text that any JSON reader takes, whatever is in the strings.
#include <nlohmann/json.hpp>
#include <random>

#include "tests/unit/settings/refusal.h"
#include "wire/messages.h"

namespace cloudscape::wire {
namespace {

TEST(ServerMessages, AreWrittenAsTheyAreRead) {
  const Welcome welcome{
      "0.1.0", "llvmpipe", true,       "overcast",   CameraPose{{1, 2, 3}, 4, 5, 6}, Lens{}, Display{},
      135,     40,         {640, 360}, {3840, 3840}, "2026-06-21T12:00:00Z",         60};
  const ServerMessage messages[]{welcome, Stats{24.5, 8e6, 31, 40, 6, 18446744073709551615u, 3},
                                 ErrorMessage{"/pose is missing", "/pose", true}, ClockState{12.5, -60, false}};
  for (const ServerMessage& message : messages) {
    const ServerMessage again = parse_server_message(to_text(message));
    EXPECT_EQ(again.index(), message.index());
    EXPECT_EQ(to_text(again), to_text(message));
  }
  const auto json = nlohmann::json::parse(to_text(ServerMessage{welcome}));
  EXPECT_EQ(json["type"], "welcome");
  EXPECT_EQ(json["size_px"], (nlohmann::json{640, 360}));
  EXPECT_EQ(json["sun_elevation_deg"], 40);
  EXPECT_EQ(json["pose"]["position_m"], (nlohmann::json{1, 2, 3}));
}

TEST(ServerMessages, ErrorsAreValidJsonWhateverTheirBytes) {
  std::mt19937 random(3);
  for (int round = 0; round < 2000; ++round) {
    std::string bytes(random() % 40, ' ');
    for (char& c : bytes) c = static_cast<char>(random());
    const std::string text = to_text(ServerMessage{ErrorMessage{bytes, bytes, false}});
    ASSERT_TRUE(nlohmann::json::accept(text)) << text;
    EXPECT_NO_THROW(parse_server_message(text));
  }
}

TEST(ServerMessages, AreRefusedWithOneSentence) {
  const auto sentence = [](const std::string& text) { return refusal([&] { parse_server_message(text); }).sentence; };
  EXPECT_EQ(sentence(R"({"type": "hello"})"), R"(/type is "hello": must be one of welcome, stats, error, clock)");
  EXPECT_EQ(sentence("{}"), "/type is missing");
  EXPECT_EQ(sentence(R"({"type": "stats", "window": "1"})"), R"(/window is "1": must be a whole number)");
}

TEST(ServerMessages, DamagedOnesAreRefusedOrReadAndNothingElse) {
  const std::string whole = to_text(ServerMessage{Welcome{}});
  std::mt19937 random(11);
  for (int round = 0; round < 5000; ++round) {
    std::string text = whole;
    text[random() % text.size()] = static_cast<char>(random());
    if (round % 3 == 0) text.erase(random() % text.size());
    try {
      parse_server_message(text);
    } catch (const InvalidInput&) {
    }
  }
}

}  // namespace
}  // namespace cloudscape::wire
