// Stills from queries and from JSON bodies: one meaning, one validation.
#include <set>

#include "core/content_hash.h"
#include "settings/still_request.h"
#include "tests/unit/settings/refusal.h"

namespace cloudscape::settings {
namespace {

using testing::HasSubstr;

class Stills : public testing::Test {
 protected:
  StillRequest query(Parameters parameters, const StillLimits& limits = {}) const {
    parameters.insert(parameters.begin(), {"cloudscape", "overcast"});
    return still_from_parameters(parameters, library, limits);
  }
  StillRequest body(const std::string& members, const StillLimits& limits = {}) const {
    return still_from_json(R"({"cloudscape": "overcast")" + (members.empty() ? "" : ", " + members) + "}", library,
                           limits);
  }
  std::string sentence(const Parameters& parameters) const {
    return refusal([&] { query(parameters); }).sentence;
  }
  CloudscapeLibrary library{{}};
};

TEST_F(Stills, DefaultsComeFromTheDocumentsView) {
  const StillRequest still = query({});
  const auto overcast = library.get("overcast");
  EXPECT_EQ(*still.frame.cloudscape, *overcast);
  EXPECT_EQ(still.frame.pose, overcast->view.pose);
  EXPECT_EQ(still.frame.lens, overcast->view.lens);
  EXPECT_EQ(still.frame.display, overcast->view.display);
  EXPECT_EQ(still.frame.size_px, (ImageSize{640, 360}));
  EXPECT_EQ(still.frame.quality, render_quality(Quality::standard));
  EXPECT_EQ(still.frame.content, FrameContent::display);
  EXPECT_EQ(still.encoding, (Encoding{ImageFormat::jpeg, 90, ChromaSubsampling::none, ExrType::half}));
}

TEST_F(Stills, EveryParameterArrives) {
  const StillRequest still = query({{"position", "1,-2.5,3e3"},
                                    {"azimuth_deg", "-10"},
                                    {"elevation_deg", "5.5"},
                                    {"roll_deg", "1"},
                                    {"vertical_fov_deg", "70"},
                                    {"lens", "orthographic"},
                                    {"width_m", "5000"},
                                    {"width", "320"},
                                    {"height", "200"},
                                    {"quality", "high"},
                                    {"samples", "3"},
                                    {"time_s", "60"},
                                    {"exposure_ev", "-1"},
                                    {"tone_curve", "aces"},
                                    {"dither", "false"},
                                    {"format", "jpeg"},
                                    {"jpeg_quality", "75"}});
  EXPECT_EQ(still.frame.pose, (CameraPose{{1, -2.5, 3000}, -10, 5.5, 1}));
  EXPECT_EQ(still.frame.lens, (Lens{LensKind::orthographic, 70, 5000}));
  EXPECT_EQ(still.frame.size_px, (ImageSize{320, 200}));
  RenderQuality high = render_quality(Quality::high);
  high.samples = 3;
  EXPECT_EQ(still.frame.quality, high);
  EXPECT_EQ(still.frame.time_s, 60);
  EXPECT_EQ(still.frame.display, (Display{-1, ToneCurve::aces, false}));
  EXPECT_EQ(still.encoding.jpeg_quality, 75);
}

TEST_F(Stills, ReferencesAreTraced) {
  const StillRequest still = query({{"quality", "reference"}, {"seed", "7"}, {"max_scattering_order", "1"}});
  EXPECT_EQ(still.frame.quality.technique, Technique::path_tracing);
  EXPECT_EQ(still.frame.quality.samples, 64);
  EXPECT_EQ(still.frame.tracing, (Tracing{7, TracedAtmosphere::tables, 1, {}, {}}));
  const StillRequest small =
      query({{"quality", "reference"}, {"noise_target", "0.01"}, {"width", "64"}, {"height", "36"}});
  EXPECT_EQ(small.frame.quality.samples, 4096);
  EXPECT_EQ(query({{"quality", "reference"}, {"time_budget_s", "2"}, {"samples", "9"}}).frame.quality.samples, 9);
  EXPECT_EQ(sentence({{"max_scattering_order", "0"}}), "/max_scattering_order is 0: must be within [1, 65535]");
}

TEST_F(Stills, OnlyAClearSkysAirIsTraced) {
  const Parameters traced{{"quality", "reference"}, {"atmosphere", "traced"}};
  EXPECT_EQ(query(traced).frame.tracing.atmosphere, TracedAtmosphere::traced);
  EXPECT_EQ(query({{"atmosphere", "traced"}}).canonical, query({}).canonical) << "a march has no use for it";
  EXPECT_EQ(sentence({{"quality", "reference"}, {"atmosphere", "tracd"}}).find("/atmosphere is"), 0U);
  Cloudscape grey = *library.get("overcast");
  grey.sky.kind = SkyKind::uniform;
  const std::string asked =
      R"({"cloudscape": )" + to_json(grey) +
      R"(, "image": {"quality": "reference", "atmosphere": "traced", "width": 64, "height": 36}})";
  try {
    still_from_json(asked, library, {});
    FAIL() << "a uniform sky was traced";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("/image/atmosphere is traced, but the cloudscape's sky is uniform"),
              std::string::npos)
        << error.what();
  }
}

// What has no meaning without path tracing does not make two pictures of one.
TEST_F(Stills, OnlyReferencesHaveASeed) {
  EXPECT_EQ(query({{"seed", "7"}}).canonical, query({}).canonical);
  EXPECT_NE(query({{"quality", "reference"}, {"seed", "7"}}).canonical, query({{"quality", "reference"}}).canonical);
}

TEST_F(Stills, ExrIsRadiance) {
  const StillRequest still = query({{"format", "exr"}, {"exr_type", "float"}});
  EXPECT_EQ(still.frame.content, FrameContent::radiance);
  EXPECT_EQ(still.encoding.exr_type, ExrType::float32);
}

TEST_F(Stills, TheSunMovesInACopyOfTheDocument) {
  const StillRequest still = query({{"sun_azimuth_deg", "200.5"}, {"sun_elevation_deg", "-3"}});
  EXPECT_EQ(still.frame.cloudscape->sun.azimuth_deg, 200.5);
  EXPECT_EQ(still.frame.cloudscape->sun.elevation_deg, -3);
  const Sun sun = library.get("overcast")->sun;
  EXPECT_NE(sun.azimuth_deg, 200.5);
  EXPECT_EQ(query({{"sun_azimuth_deg", std::to_string(sun.azimuth_deg)}}).frame.cloudscape, library.get("overcast"))
      << "no needless copy";
}

TEST_F(Stills, QueryAndBodyOfOneMeaningAreOneCanonicalText) {
  const StillRequest from_query = query({{"format", "png"},
                                         {"position", "1.50,2,3"},
                                         {"sun_elevation_deg", "12"},
                                         {"lens", "fisheye"},
                                         {"height", "100"},
                                         {"quality", "draft"},
                                         {"exposure_ev", "1e0"}});
  const StillRequest from_body =
      body(R"("sun": {"elevation_deg": 12.0}, "image": {"exposure_ev": 1, "quality": "draft", "height": 100,
              "format": "png"}, "camera": {"lens": {"kind": "fisheye"}, "position_m": [1.5, 2, 3]})");
  EXPECT_EQ(from_query.canonical, from_body.canonical);
  EXPECT_EQ(*from_query.frame.cloudscape, *from_body.frame.cloudscape);
}

TEST_F(Stills, CanonicalTextNamesTheDocumentByWhatItSays) {
  Cloudscape changed = *library.get("overcast");
  const auto inline_text = [&] {
    return still_from_json(R"({"cloudscape": )" + to_json(changed) + "}", library, {}).canonical;
  };
  EXPECT_EQ(inline_text(), query({}).canonical);
  changed.seed += 1;
  EXPECT_NE(inline_text(), query({}).canonical);
}

TEST_F(Stills, EveryParameterThatMattersChangesTheCanonicalText) {
  std::set<std::string> texts{query({}).canonical};
  const Parameters changes{
      {"position", "1,2,3"},     {"azimuth_deg", "1"},       {"elevation_deg", "1"}, {"roll_deg", "1"},
      {"vertical_fov_deg", "9"}, {"lens", "panorama"},       {"width_m", "9"},       {"width", "9"},
      {"height", "9"},           {"quality", "draft"},       {"samples", "2"},       {"time_s", "1"},
      {"sun_azimuth_deg", "1"},  {"sun_elevation_deg", "1"}, {"exposure_ev", "0.1"}, {"tone_curve", "none"},
      {"dither", "false"},       {"format", "png"},          {"format", "exr"},      {"jpeg_quality", "1"}};
  for (const auto& change : changes) texts.insert(query({change}).canonical);
  texts.insert(query({{"format", "exr"}, {"exr_type", "float"}}).canonical);
  EXPECT_EQ(texts.size(), changes.size() + 2);
}

TEST_F(Stills, WhatCannotChangeThePictureDoesNotChangeTheCanonicalText) {
  EXPECT_EQ(query({{"exr_type", "float"}}).canonical, query({}).canonical);
  EXPECT_EQ(query({{"samples", "8"}}).canonical, query({}).canonical) << "8 is what standard takes";
  EXPECT_EQ(query({{"format", "png"}, {"jpeg_quality", "3"}}).canonical, query({{"format", "png"}}).canonical);
  EXPECT_EQ(query({{"format", "exr"}, {"exposure_ev", "3"}}).canonical, query({{"format", "exr"}}).canonical);
  EXPECT_EQ(query({{"time_s", "-0"}}).canonical, query({{"time_s", "0.0"}}).canonical);
}

TEST_F(Stills, RefusesParametersWithTheirNames) {
  EXPECT_EQ(sentence({{"width", "abc"}}), R"(/width is "abc": must be a whole number)");
  EXPECT_EQ(sentence({{"width", "12px"}}), R"(/width is "12px": must be a whole number)");
  EXPECT_EQ(sentence({{"width", ""}}), R"(/width is "": must be a whole number)");
  EXPECT_EQ(sentence({{"width", "0"}}), "/width is 0: must be within [1, 65535]");
  EXPECT_EQ(sentence({{"samples", "65537"}}), "/samples is 65537: must be within [1, 65536]");
  EXPECT_EQ(sentence({{"elevation_deg", "91"}}), "/elevation_deg is 91: must be within [-90, 90]");
  for (const char* text : {"nan", "inf", "-inf", "1e999", "0x10", " 1", "1 "})
    EXPECT_EQ(sentence({{"azimuth_deg", text}}), "/azimuth_deg is \"" + std::string(text) + "\": must be a number");
  EXPECT_EQ(sentence({{"position", "1,2"}}), "/position has 2 elements: must have 3");
  EXPECT_EQ(sentence({{"position", "1,x,2"}}), R"(/position/1 is "x": must be a number)");
  EXPECT_EQ(sentence({{"quality", "best"}}),
            R"(/quality is "best": must be one of draft, interactive, standard, high, finest, reference)");
  EXPECT_EQ(sentence({{"widht", "1"}}), "/widht is not a known parameter: did you mean width?");
  EXPECT_EQ(sentence({{"width", "1"}, {"width", "1"}}), "/width stands twice: keep one of the two");
  EXPECT_THAT(sentence({{"\xff\n", "\xff\n"}}), HasSubstr("is not a known parameter"));
  EXPECT_THAT(sentence({{"format", "\xff\n"}}), HasSubstr("must be one of jpeg, png, exr"));
}

TEST_F(Stills, RefusesBodiesWithPointers) {
  const auto pointer = [&](const std::string& members) { return refusal([&] { body(members); }).pointer; };
  EXPECT_EQ(pointer(R"("camera": {"lens": {"vertical_fov_deg": 500}})"), "/camera/lens/vertical_fov_deg");
  EXPECT_EQ(pointer(R"("image": {"widht": 1})"), "/image/widht");
  EXPECT_EQ(pointer(R"("sun": {"irradiance": [1, 1, 1]})"), "/sun/irradiance");
  EXPECT_EQ(pointer(R"("picture": {})"), "/picture");
  const auto document = [&](const std::string& text) {
    return refusal([&] { still_from_json(R"({"cloudscape": )" + text + "}", library, {}); }).sentence;
  };
  EXPECT_EQ(document(R"({"sky": {"haze": -1}})"), "/cloudscape/sky/haze is -1: must be within [0, 20]");
  EXPECT_EQ(document("7"), "/cloudscape is 7: must be a cloudscape's name or a whole document");
}

TEST_F(Stills, TheCloudscapeMustBeNamedAndKnown) {
  const auto missing = "/cloudscape is missing: must name a cloudscape, such as fair-weather-cumulus";
  EXPECT_EQ(refusal([&] { still_from_parameters({}, library, {}); }).sentence, missing);
  EXPECT_EQ(refusal([&] { still_from_json("{}", library, {}); }).sentence, missing);
  EXPECT_EQ(refusal<NotFound>([&] {
              still_from_parameters({{"cloudscape", "overcats"}}, library, {});
            }).sentence,
            R"(there is no cloudscape "overcats": did you mean overcast?)");
}

TEST_F(Stills, WorkAboveTheServersLimitsIsNamed) {
  const auto over = [&](const Parameters& parameters, const StillLimits& limits) {
    return refusal<OverLimit>([&] { query(parameters, limits); });
  };
  EXPECT_EQ(over({{"width", "101"}}, {100, 9, 60}).sentence, "/width is 101: this server's limit is 100 pixels a side");
  EXPECT_EQ(over({{"height", "4097"}}, {}).pointer, "/height");
  EXPECT_EQ(over({{"width", "2000"}, {"height", "1000"}}, {4096, 1.5, 60}).sentence,
            "/width times height is 2 megapixels: this server's limit is 1.5");
  const std::string work =
      over({{"width", "1000"}, {"height", "1000"}, {"quality", "finest"}, {"samples", "100"}}, {}).sentence;
  EXPECT_THAT(work, HasSubstr("/quality asks for 2560 gigasteps"));
  EXPECT_THAT(work, HasSubstr("limit is 1500 (max_still_gigasteps); lower"));
  EXPECT_EQ(refusal<OverLimit>([&] { body(R"("image": {"width": 5000})"); }).pointer, "/image/width");
  EXPECT_NO_THROW(query({{"width", "3840"}, {"height", "2160"}}));
}

TEST_F(Stills, LightStepsAreWork) {
  const auto march = [&](int max_steps, int light_steps) {
    const std::string steps = std::to_string(max_steps) + R"(, "light_steps": )" + std::to_string(light_steps);
    return body(R"("image": {"width": 1000, "height": 1000, "samples": 1}, "march": {"max_steps": )" + steps + "}",
                {.max_gigasteps = 1});
  };
  EXPECT_EQ(gigasteps_of(march(100, 9).frame), 1);
  const auto refused = refusal<OverLimit>([&] { march(100, 10); });
  EXPECT_EQ(refused.pointer, "/image/quality");
  EXPECT_THAT(refused.sentence,
              HasSubstr("asks for 1.1 gigasteps (pixels * samples * steps * (1 + light steps) / 1e9)"));
  EXPECT_THROW(march(101, 9), OverLimit);
}

// What the qualities ask for of themselves is allowed, as large as it is worth.
TEST_F(Stills, EveryQualityIsAllowedByDefault) {
  for (const char* quality : {"draft", "interactive", "standard"})
    EXPECT_NO_THROW(query({{"width", "3840"}, {"height", "2160"}, {"quality", quality}}));
  EXPECT_NO_THROW(query({{"width", "1920"}, {"height", "1080"}, {"quality", "high"}}));
  EXPECT_NO_THROW(query({{"width", "1152"}, {"height", "648"}, {"quality", "reference"}}));
  for (const auto& preset : library.list())
    EXPECT_NO_THROW(
        still_from_parameters({{"cloudscape", preset.name}, {"width", "1920"}, {"height", "1080"}}, library, {}));
}

TEST_F(Stills, TexturesAboveTheServersLimitAreNamed) {
  const auto asked = [&](int resolution, const std::string& format, double max_bake_mib) {
    const std::string volume =
        R"({"resolution": )" + std::to_string(resolution) + R"(, "format": ")" + format + R"("})";
    still_from_json(R"({"cloudscape": {"volume": )" + volume + "}}", library, {.max_bake_mib = max_bake_mib});
  };
  const auto refused = refusal<OverLimit>([&] { asked(512, "rgba8", 128); });
  EXPECT_EQ(refused.pointer, "/cloudscape/volume/resolution");
  EXPECT_THAT(refused.sentence,
              HasSubstr("is 512 in rgba8, whose textures take 512.375 MiB: this server's limit is 128"));
  EXPECT_THAT(refused.sentence, HasSubstr("max_bake_mib"));
  EXPECT_THROW(asked(512, "r16f", 128), OverLimit);
  EXPECT_NO_THROW(asked(512, "r16f", 257));
  EXPECT_NO_THROW(asked(256, "rgba8", StillLimits{}.max_bake_mib));
  EXPECT_THROW(query({}, {.max_bake_mib = 1}), OverLimit);
}

TEST_F(Stills, ParametersDescribeThemselves) {
  const auto parameters = still_parameters({2048, 9, 60});
  const auto find = [&](const std::string& name) {
    for (const auto& parameter : parameters)
      if (parameter.name == name) return parameter;
    ADD_FAILURE() << name << " is not described";
    return ParameterInfo{};
  };
  EXPECT_EQ(parameters.front().name, "cloudscape");
  EXPECT_EQ(find("width").max, 2048);
  EXPECT_EQ(find("width").default_text, "640");
  EXPECT_EQ(find("samples").default_text, "the quality's");
  EXPECT_EQ(find("elevation_deg").min, -90);
  EXPECT_EQ(find("exposure_ev").default_text, "the cloudscape's view");
  EXPECT_EQ(find("sun_azimuth_deg").default_text, "the cloudscape's sun");
  EXPECT_EQ(find("format").values, (std::vector<std::string>{"jpeg", "png", "exr"}));
  EXPECT_EQ(find("position").type, "string");
  EXPECT_EQ(find("jpeg_quality").type, "integer");
  EXPECT_EQ(find("time_s").type, "number");
}

// NREL's example: azimuth 194.34, elevation 39.89.
TEST_F(Stills, SunStandsByPlaceAndTime) {
  const StillRequest still =
      query({{"latitude_deg", "39.742476"}, {"longitude_deg", "-105.1786"}, {"time_utc", "2003-10-17T19:30:30Z"}});
  EXPECT_NEAR(still.frame.cloudscape->sun.azimuth_deg, 194.34, 0.01);
  EXPECT_NEAR(still.frame.cloudscape->sun.elevation_deg, 39.89, 0.01);
  const StillRequest same = body(
      R"("sun": {"place": {"latitude_deg": 39.742476, "longitude_deg": -105.1786, "time_utc": "2003-10-17T19:30:30Z"}})");
  EXPECT_EQ(*same.frame.cloudscape, *still.frame.cloudscape);
  EXPECT_NE(still.canonical, query({}).canonical);
}

TEST_F(Stills, ANewAngleTakesTheSunFromItsPlace) {
  const std::string document = R"({"cloudscape": {"sun": {"place": {"time_utc": "2026-06-21T12:00:00Z"}}})";
  const StillRequest placed = still_from_json(document + "}", library, {});
  EXPECT_GT(placed.frame.cloudscape->sun.elevation_deg, 60);
  const StillRequest turned = still_from_json(document + R"(, "sun": {"elevation_deg": 5}})", library, {});
  EXPECT_EQ(turned.frame.cloudscape->sun.elevation_deg, 5);
  EXPECT_EQ(turned.frame.cloudscape->sun.place.time_utc, "");
}

TEST_F(Stills, APlaceNeedsATimeThatThereIs) {
  EXPECT_EQ(sentence({{"latitude_deg", "50"}}),
            "/time_utc is missing: a place needs a time, such as 2026-06-21T12:00:00Z");
  EXPECT_THAT(sentence({{"time_utc", "noon"}}), HasSubstr("/time_utc is \"noon\": must be a time from 1901 to 2099"));
  EXPECT_THAT(sentence({{"latitude_deg", "91"}, {"time_utc", "2026-06-21T12:00:00Z"}}), HasSubstr("within [-90, 90]"));
}

}  // namespace
}  // namespace cloudscape::settings
