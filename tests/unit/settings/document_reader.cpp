// Reading cloudscape documents: every kind of error says what, where and what would be right.
#include <limits>
#include <random>

#include "core/content_hash.h"
#include "settings/cloudscape_json.h"
#include "tests/unit/settings/refusal.h"

namespace cloudscape::settings {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

Cloudscape parsed(std::string_view text) { return parse_cloudscape(text, "sky.json"); }
std::string sentence(std::string_view text) {
  return refusal([&] { parsed(text); }).sentence;
}

TEST(DocumentReader, EmptyObjectIsTheDefaultSky) { EXPECT_EQ(parsed("{}"), Cloudscape{}); }

TEST(DocumentReader, FillsEveryKindOfValue) {
  const Cloudscape sky = parsed(R"({
    "title": "Größe", "seed": 4294967295,
    "volume": {"kind": "slab", "resolution": 64, "tiling": false, "size_m": [1, 2.5, 3e3]},
    "shape": {"threshold": 0.4, "towers": [{"center": [0.25, 0.75]}, {"radius": 0.1}]},
    "noise": {"channels": [{"gain": 0.25}, {}, {}, {"frequency": 16}]},
    "medium": {"phase": {"kind": "two-lobe"}}})");
  EXPECT_EQ(sky.title, "Größe");
  EXPECT_EQ(sky.seed, 4294967295u);
  EXPECT_EQ(sky.volume.kind, VolumeKind::slab);
  EXPECT_FALSE(sky.volume.tiling);
  EXPECT_EQ(sky.volume.size_m, glm::dvec3(1, 2.5, 3000));
  EXPECT_EQ(sky.shape.threshold, 0.4);
  ASSERT_EQ(sky.shape.towers.size(), 2u);
  EXPECT_EQ(sky.shape.towers[0].center, glm::dvec2(0.25, 0.75));
  EXPECT_EQ(sky.shape.towers[1].center, Tower{}.center);
  EXPECT_EQ(sky.noise.channels[0].gain, 0.25);
  EXPECT_EQ(sky.noise.channels[1], Noise{}.channels[1]) << "a channel keeps the defaults of its own place";
  EXPECT_EQ(sky.medium.phase.kind, PhaseKind::two_lobe);
}

TEST(DocumentReader, TakesCommentsNullThresholdsWholeFloatsAndAnEditorsSchema) {
  const Cloudscape sky = parsed(R"(// a sky
    {"$schema": "sky.schema.json", /* fewer */ "shape": {"threshold": null}, "volume": {"resolution": 64.0}})");
  EXPECT_EQ(sky.shape.threshold, std::nullopt);
  EXPECT_EQ(sky.volume.resolution, 64);
}

TEST(DocumentReader, RefusesWhatIsOutOfRangeWithPointerValueAndRange) {
  const Refusal over = refusal([] { parsed(R"({"medium": {"single_scattering_albedo": 1.2}})"); });
  EXPECT_EQ(over.sentence, "/medium/single_scattering_albedo is 1.2: must be within [0, 1]");
  EXPECT_EQ(over.pointer, "/medium/single_scattering_albedo");
  EXPECT_EQ(sentence(R"({"sun": {"irradiance": [1, -0.5, 2]}})"),
            "/sun/irradiance/1 is -0.5: must be within [0, 1000000]");
  EXPECT_EQ(sentence(R"({"noise": {"channels": [{}, {}, {"octaves": 9}, {}]}})"),
            "/noise/channels/2/octaves is 9: must be within [1, 8]");
  EXPECT_EQ(sentence(R"({"seed": -1})"), "/seed is -1: must be within [0, 4294967295]");
  EXPECT_EQ(sentence(R"({"seed": 18446744073709551615})"),
            "/seed is 18446744073709551615: must be within [0, 4294967295]");
}

TEST(DocumentReader, AcceptsBothEndsOfARangeAndNothingBeyond) {
  EXPECT_EQ(parsed(R"({"sky": {"haze": 0}})").sky.haze, 0);
  EXPECT_EQ(parsed(R"({"sky": {"haze": 20}})").sky.haze, 20);
  EXPECT_THAT(sentence(R"({"sky": {"haze": 20.000001}})"), HasSubstr("within [0, 20]"));
  EXPECT_THAT(sentence(R"({"sky": {"haze": -5e-324}})"), HasSubstr("within [0, 20]"));
}

TEST(DocumentReader, RefusesNumbersThatAreNoPowersOfTwo) {
  for (const char* value : {"8", "100", "1024", "0", "-16"})
    EXPECT_EQ(sentence(R"({"volume": {"resolution": )" + std::string(value) + "}}"),
              "/volume/resolution is " + std::string(value) + ": must be a power of two within [16, 512]");
}

TEST(DocumentReader, RefusesWrongTypes) {
  EXPECT_EQ(sentence(R"({"sun": {"azimuth_deg": "north"}})"), R"(/sun/azimuth_deg is "north": must be a number)");
  EXPECT_EQ(sentence(R"({"sun": {"azimuth_deg": null}})"), "/sun/azimuth_deg is null: must be a number");
  EXPECT_EQ(sentence(R"({"sun": {"azimuth_deg": true}})"), "/sun/azimuth_deg is true: must be a number");
  EXPECT_EQ(sentence(R"({"sun": 5})"), "/sun is 5: must be an object");
  EXPECT_EQ(sentence(R"({"title": 5})"), "/title is 5: must be a string");
  EXPECT_EQ(sentence(R"({"sun": {"disc": 1}})"), "/sun/disc is 1: must be true or false");
  EXPECT_EQ(sentence(R"({"volume": {"origin_m": 3}})"), "/volume/origin_m is 3: must be an array");
  EXPECT_EQ(sentence(R"({"seed": 1.5})"), "/seed is 1.5: must be a whole number within [0, 4294967295]");
  EXPECT_EQ(sentence(R"({"seed": "1"})"), R"(/seed is "1": must be a whole number)");
  EXPECT_EQ(sentence("[]"), "the document is []: must be an object");
}

TEST(DocumentReader, RefusesUnknownChoices) {
  EXPECT_EQ(sentence(R"({"sky": {"kind": "blue"}})"), R"(/sky/kind is "blue": must be one of none, uniform, clear)");
  EXPECT_EQ(sentence(R"({"sky": {"kind": 2}})"), "/sky/kind is 2: must be one of none, uniform, clear");
}

TEST(DocumentReader, CountsElementsAndCharacters) {
  EXPECT_EQ(sentence(R"({"sun": {"irradiance": [1, 2]}})"), "/sun/irradiance has 2 elements: must have 3");
  EXPECT_EQ(sentence(R"({"noise": {"channels": [{}, {}, {}]}})"), "/noise/channels has 3 elements: must have 4");
  std::string towers;
  for (int i = 0; i < 33; ++i) towers += i ? ",{}" : "{}";
  EXPECT_EQ(sentence(R"({"shape": {"towers": [)" + towers + "]}}"),
            "/shape/towers has 33 elements: must have at most 32");
  const std::string eighty_umlauts = [] {
    std::string text;
    for (int i = 0; i < 80; ++i) text += "ü";
    return text;
  }();
  EXPECT_EQ(parsed(R"({"title": ")" + eighty_umlauts + "\"}").title, eighty_umlauts);
  EXPECT_EQ(sentence(R"({"title": ")" + eighty_umlauts + "x\"}"), "/title has 81 characters: must have at most 80");
}

TEST(DocumentReader, NamesTheNearestKnownKey) {
  EXPECT_EQ(sentence(R"({"medium": {"extinction": 1}})"),
            "/medium/extinction is not a known key: did you mean extinction_per_m?");
  EXPECT_EQ(sentence(R"({"cloudz": {}, "medium": {}})").substr(0, 30), "/cloudz is not a known key: kn");
  EXPECT_THAT(sentence(R"({"Sun": {}})"), HasSubstr("did you mean sun?"));
  EXPECT_THAT(sentence(R"({"shape": {"covrage": 1}})"), HasSubstr("did you mean coverage?"));
  EXPECT_THAT(sentence(R"({"view": {"lens": {"fov": 1}}})"), HasSubstr("did you mean vertical_fov_deg?"));
  EXPECT_EQ(sentence(R"({"wind": {"x": 1}})"),
            "/wind/x is not a known key: known are speed_m_per_s, towards_azimuth_deg, shear_per_s, evolution_m_per_s");
}

TEST(DocumentReader, NamesLineAndColumnOfWrongSyntax) {
  const std::string text = sentence("{\n  \"seed\": ,\n}");
  EXPECT_THAT(text, StartsWith("sky.json: line 2, column 11: syntax error"));
  EXPECT_THAT(sentence(""), HasSubstr("sky.json is empty"));
  EXPECT_THAT(sentence(" \n"), HasSubstr("sky.json is empty"));
  EXPECT_THAT(sentence("// only a comment"), StartsWith("sky.json: line 1"));
  EXPECT_THAT(sentence(R"({"seed": 1} x)"), StartsWith("sky.json: line 1"));
  EXPECT_THAT(sentence(R"({"seed": NaN})"), StartsWith("sky.json: line 1"));
}

TEST(DocumentReader, RefusesNumbersThatNoDoubleHolds) {
  EXPECT_THAT(sentence(R"({"sky": {"haze": 1e999}})"), HasSubstr("1e999"));
  EXPECT_THAT(sentence(R"({"sky": {"haze": -1e999}})"), HasSubstr("1e999"));
}

TEST(DocumentReader, RefusesAKeyThatStandsTwice) {
  EXPECT_EQ(sentence(R"({"seed": 1, "seed": 2})"), "/seed stands twice: keep one of the two");
  EXPECT_EQ(sentence(R"({"shape": {"towers": [{}, {"top": 1, "radius": 0.1, "top": 0}]}})"),
            "/shape/towers/1/top stands twice: keep one of the two");
  EXPECT_NO_THROW(parsed(R"({"shape": {"towers": [{"top": 1}, {"top": 1}]}, "detail": {"strength": 0}})"));
}

TEST(DocumentReader, RefusesBottomlessNesting) {
  EXPECT_EQ(sentence(std::string(100000, '[')), "sky.json nests deeper than 32 levels");
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_EQ(sentence(objects), "sky.json nests deeper than 32 levels");
}

TEST(DocumentReader, MessagesAreOneShortLineOfAscii) {
  const std::string control = "\\u001b[31m\\n\\u202e";
  for (const std::string& text :
       {R"({"title": [")" + std::string(100000, 'x') + "\"]}", R"({")" + std::string(100000, 'y') + R"(": 1})",
        R"({")" + control + R"(": 1})", R"({"seed": ")" + control + R"("})", std::string("{\"seed\": \"\xff\"}"),
        std::string("{\"seed\": \x1b}"), R"({"seed": )" + std::string(5000, '9') + "}",
        R"({"seed": 1)" + std::string(5000, 'e') + "}"}) {
    const std::string message = sentence(text);
    EXPECT_NE(message, "was not refused") << text.substr(0, 40);
    EXPECT_LT(message.size(), 600u) << text.substr(0, 40);
    for (const char c : message) EXPECT_TRUE(c >= 0x20 && c < 0x7F) << message;
  }
}

TEST(DocumentReader, PointersEscapeWhatRfc6901Reserves) {
  EXPECT_EQ(refusal([] { parsed(R"({"a/b~c": 1})"); }).pointer, "/a~1b~0c");
}

TEST(DocumentReader, NoiseFinerThanTheTextureIsRefusedWithTheRule) {
  EXPECT_EQ(sentence(R"({"volume": {"resolution": 32}})"),
            "/noise/channels/1 has 64 cells a tile in its last octave (frequency * lacunarity^(octaves - 1)): must be "
            "at most volume.resolution, 32");
  EXPECT_NO_THROW(parsed(R"({"volume": {"resolution": 64}})"));
  EXPECT_NO_THROW(parsed(R"({"volume": {"resolution": 16, "kind": "sphere"}})")) << "a sphere has no noise";
  EXPECT_THAT(sentence(R"({"detail": {"frequency": 16, "octaves": 3}})"), StartsWith("/detail has 64 cells"));
}

TEST(DocumentReader, WritesWhatItReads) {
  Cloudscape sky;
  sky.title = "tab\t \"quote\" ü";
  sky.shape.threshold = 0.1 + 0.2;
  sky.shape.towers = {Tower{}, Tower{{0.1, 1.0 / 3}, 0.07, 0.8, 1.5}};
  sky.sun.irradiance = {1e-7, 123456.789, 1e6};
  sky.medium.light_model.kind = LightModelKind::olajos;
  const std::string text = to_json(sky);
  EXPECT_EQ(parsed(text), sky);
  EXPECT_EQ(to_json(parsed(text)), text);
  EXPECT_EQ(content_hash(parsed(text)), content_hash(sky));
}

// Bytes changed at random in a whole document: either it is a document, or there is a sentence; nothing else.
TEST(DocumentReader, DamagedTextIsRefusedOrRead) {
  const std::string whole = to_json(Cloudscape{});
  std::mt19937 random(1);
  int refused = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string text = whole;
    for (unsigned change = 0; change <= random() % 3; ++change)
      text[random() % text.size()] = static_cast<char>(random() % 256);
    if (round % 5 == 0) text.resize(random() % text.size());
    try {
      parsed(text);
    } catch (const InvalidInput&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
}

TEST(HeightMapNames, AreBareNamesOfPictures) {
  const auto read = [](const std::string& name) {
    return parse_cloudscape(R"({"ground": {"terrain": {"height_map": ")" + name + "\"}}}", "text")
        .ground.terrain.height_map;
  };
  for (const char* name : {"", "alps.png", "Piz Bernina 16 bit.exr"}) EXPECT_EQ(read(name), name);
  for (const char* name : {"../alps.png", "/alps.png", "maps/alps.png", "..", ".png", ".hidden.png", "alps", "alps.jpg",
                           "maps\\\\alps.png", "a\\u0000.png", "a\\n.png"}) {
    const Refusal refused = refusal([&] { read(name); });
    EXPECT_EQ(refused.pointer, "/ground/terrain/height_map") << name;
    EXPECT_THAT(refused.sentence, testing::HasSubstr("bare name")) << name;
  }
}

TEST(DocumentReader, PutsTheSunWhereItStandsAtAPlaceAndTime) {
  const Cloudscape sky = parsed(
      R"({"sun": {"place": {"latitude_deg": 39.742476, "longitude_deg": -105.1786, "time_utc": "2003-10-17T19:30:30Z"}}})");
  EXPECT_NEAR(sky.sun.azimuth_deg, 194.34, 0.01);
  EXPECT_EQ(parsed(to_json(sky)), sky);
  EXPECT_THAT(sentence(R"({"sun": {"place": {"time_utc": "2026-02-30T12:00:00Z"}}})"),
              StartsWith("/sun/place/time_utc is \"2026-02-30T12:00:00Z\": must be a time from 1901 to 2099"));
}

}  // namespace
}  // namespace cloudscape::settings
