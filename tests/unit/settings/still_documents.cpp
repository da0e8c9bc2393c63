// Stills as documents: by name, by file, and with what is asked for beside them.
#include "settings/still_documents.h"

#include <filesystem>
#include <set>
#include <sstream>

#include "settings/still_request.h"
#include "settings/text_file.h"
#include "tests/unit/settings/refusal.h"

namespace cloudscape::settings {
namespace {

using testing::HasSubstr;

const char* const document = R"({
  "title": "A test", "cloudscape": {"seed": 5, "view": {"pose": {"azimuth_deg": 10}}},
  "camera": {"elevation_deg": 33}, "image": {"width": 320, "height": 200, "quality": "draft"},
  "march": {"light_steps": 3}, "medium": {"phase": {"kind": "mie"}}})";

class StillDocuments : public testing::Test {
 protected:
  StillRequest read(const std::string& text, const Parameters& parameters = {}, const std::string& source = "") const {
    return still_from_document({text, source}, parameters, library, {});
  }
  Refusal refused(const std::string& text, const std::string& source, const Parameters& parameters = {}) const {
    return refusal([&] { read(text, parameters, source); });
  }
  CloudscapeLibrary library{{}};
};

TEST_F(StillDocuments, EachThatHasANameCanBeRendered) {
  std::set<std::string> files, names;
  for (const auto& file : std::filesystem::directory_iterator(CLOUDSCAPE_SOURCE_DIR "/config/stills"))
    files.insert(file.path().stem());
  for (const StillEntry& entry : named_stills()) {
    names.insert(entry.name);
    EXPECT_NE(entry.title, "") << entry.name;
    EXPECT_TRUE(entry.description.ends_with(".")) << entry.name;
    const StillRequest still = still_from_parameters({{"still", entry.name}}, library, {});
    EXPECT_EQ(still.canonical, still_from_json(named_still(entry.name).text, library, {}).canonical) << entry.name;
  }
  EXPECT_EQ(names, files);
}

TEST_F(StillDocuments, SoCanEachViewOfTheTruth) {
  std::set<std::string> files, names;
  for (const auto& file : std::filesystem::directory_iterator(CLOUDSCAPE_SOURCE_DIR "/config/truth"))
    files.insert(file.path().stem());
  for (const StillEntry& entry : truth_views()) {
    names.insert(entry.name);
    EXPECT_NE(entry.title, "") << entry.name;
    EXPECT_TRUE(entry.description.ends_with(".")) << entry.name;
    EXPECT_NO_THROW(still_from_document(truth_view(entry.name), {}, library, {})) << entry.name;
  }
  EXPECT_EQ(names, files);
  EXPECT_THAT(refusal<NotFound>([] { truth_view("noom"); }).sentence, HasSubstr("did you mean noon?"));
}

TEST_F(StillDocuments, MeanWhatABodyMeans) {
  const StillRequest still = read(document);
  EXPECT_EQ(still.canonical, still_from_json(document, library, {}).canonical);
  EXPECT_EQ(still.frame.pose.azimuth_deg, 10) << "the cloudscape's view";
  EXPECT_EQ(still.frame.pose.elevation_deg, 33) << "the still's camera";
  EXPECT_EQ(still.frame.march.light_steps, 3);
  EXPECT_EQ(still.frame.cloudscape->medium.phase.kind, PhaseKind::mie);
}

TEST_F(StillDocuments, WhatIsAskedBesideThemGoesFirst) {
  const StillRequest still = read(document, {{"width", "64"}, {"azimuth_deg", "20"}, {"phase", "isotropic"}});
  EXPECT_EQ(still.frame.size_px.width, 64);
  EXPECT_EQ(still.frame.size_px.height, 200);
  EXPECT_EQ(still.frame.pose.azimuth_deg, 20);
  EXPECT_EQ(still.frame.cloudscape->medium.phase.kind, PhaseKind::isotropic);
  const StillRequest other = read(document, {{"cloudscape", "overcast"}});
  EXPECT_EQ(other.frame.cloudscape->title, "Overcast");
  EXPECT_EQ(other.frame.pose.elevation_deg, 33);
  EXPECT_EQ(other.frame.pose.azimuth_deg, library.get("overcast")->view.pose.azimuth_deg);
}

TEST_F(StillDocuments, HeadingsChangeNothingOfThePicture) {
  const auto titled = [&](const std::string& title) {
    return read(R"({"cloudscape": "overcast", "title": ")" + title + "\"}").canonical;
  };
  EXPECT_EQ(titled("One"), titled("Two"));
  EXPECT_EQ(refused(R"({"cloudscape": "overcast", "title": 7})", "").sentence, "/title is 7: must be a string");
}

Parameters parameters_of(const std::string& view) {
  Parameters parameters;
  std::istringstream all(view);
  for (std::string each; std::getline(all, each, '&');)
    parameters.emplace_back(each.substr(0, each.find('=')), each.substr(each.find('=') + 1));
  return parameters;
}

// As parameters, without the document: the same place in the same light.
TEST_F(StillDocuments, TheirViewsAreParameters) {
  int views = 0;
  for (const StillEntry& entry : named_stills()) {
    if (entry.view.empty()) continue;
    ++views;
    const FrameRequest still = still_from_parameters({{"still", entry.name}}, library, {}).frame;
    const FrameRequest seen = still_from_parameters(parameters_of(entry.view), library, {}).frame;
    EXPECT_EQ(seen.pose.position_m, still.pose.position_m) << entry.name;
    EXPECT_EQ(seen.pose.azimuth_deg, still.pose.azimuth_deg) << entry.name;
    EXPECT_EQ(seen.pose.elevation_deg, still.pose.elevation_deg) << entry.name;
    EXPECT_TRUE(seen.lens == still.lens) << entry.name;
    EXPECT_EQ(seen.display.exposure_ev, still.display.exposure_ev) << entry.name;
    EXPECT_TRUE(seen.cloudscape->sun == still.cloudscape->sun) << entry.name;
    EXPECT_TRUE(seen.cloudscape->medium == still.cloudscape->medium) << entry.name;
  }
  EXPECT_GE(views, 5);
  for (const StillEntry& entry : named_stills()) {
    const bool more_than_a_stream_shows = entry.name == "fog-bow" || entry.name == "panorama";
    EXPECT_TRUE(entry.view.empty() || !more_than_a_stream_shows) << entry.name;
  }
}

TEST_F(StillDocuments, ErrorsNameTheFileOrTheParameter) {
  EXPECT_EQ(refused(R"({"cloudscape": "overcast", "image": {"widht": 1}})", "a.json").sentence,
            "a.json#/image/widht is not a known key: did you mean width?");
  EXPECT_EQ(refused(R"({"cloudscape": {"seed": -1}})", "a.json").pointer, "a.json#/cloudscape/seed");
  EXPECT_EQ(refused("{}", "a.json").pointer, "a.json#/cloudscape");
  EXPECT_THAT(refused("{", "a.json").sentence, HasSubstr("a.json"));
  EXPECT_THAT(refused("[1]", "a.json").sentence, HasSubstr("a.json#"));
  EXPECT_EQ(refused(document, "a.json", {{"widht", "1"}}).sentence,
            "/widht is not a known parameter: did you mean width?");
  EXPECT_EQ(refused(document, "a.json", {{"width", "0"}}).pointer, "/width");
}

TEST_F(StillDocuments, AreFoundByNameOrByFile) {
  EXPECT_EQ(refusal<NotFound>([] { find_still("fog-bwo"); }).sentence,
            R"(there is no still "fog-bwo": did you mean fog-bow?)");
  EXPECT_EQ(refusal<NotFound>([&] {
              still_from_parameters({{"still", "fog-bwo"}}, library, {});
            }).sentence,
            R"(there is no still "fog-bwo": did you mean fog-bow?)");
  const StillDocument file = find_still(CLOUDSCAPE_SOURCE_DIR "/config/stills/fog-bow.json");
  EXPECT_EQ(file.text, find_still("fog-bow").text);
  EXPECT_THAT(file.source, HasSubstr("fog-bow.json"));
  EXPECT_THAT(refusal<Error>([] { find_still("nowhere/a.json"); }).sentence, HasSubstr("nowhere/a.json"));
}

}  // namespace
}  // namespace cloudscape::settings
