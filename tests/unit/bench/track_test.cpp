// The test track with made-up times: which frames are drawn in which order, statistics, tables, JSON, plots.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "bench/track_report.h"
#include "tests/unit/settings/refusal.h"

namespace cloudscape::bench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using enum TrackVariant;

settings::CameraPath path_of_40_s() {
  return settings::parse_camera_path(R"({"keys": [
      {"time_s": 0, "pose": {"position_m": [0, 0, 100]}, "vertical_fov_deg": 60},
      {"time_s": 40, "pose": {"position_m": [400, 0, 100]}, "vertical_fov_deg": 60}],
    "sections": [{"name": "below", "begin_s": 0, "end_s": 20}, {"name": "above", "begin_s": 30, "end_s": 40}]})",
                                     "path");
}

std::vector<FrameRequest> requests(const std::vector<TrackVariant>& variants) {
  std::vector<FrameRequest> requests;
  for (const TrackVariant variant : variants) requests.push_back(track_request({}, {64, 36}, variant));
  return requests;
}

TEST(TrackVariants, AreNamedWithCommasAndTheBaseIsFirst) {
  EXPECT_THAT(variants_of("all"),
              ElementsAre(base, structure_off, distance_field, adaptive_on, light_off, phase_mie, phase_none));
  EXPECT_THAT(variants_of("light-off"), ElementsAre(base, light_off));
  EXPECT_THAT(variants_of("phase-none,base,phase-mie,phase-none"), ElementsAre(base, phase_none, phase_mie));
}

TEST(TrackVariants, AreRefusedByName) {
  const std::string known =
      "must be all, or names among base, structure-off, distance-field, adaptive-on, light-off, phase-mie, phase-none";
  EXPECT_EQ(refusal([] { variants_of("light-off,structure"); }).sentence, "--variants has 'structure': " + known);
  EXPECT_EQ(refusal([] { variants_of(""); }).sentence, "--variants has '': " + known);
  EXPECT_EQ(refusal([] { variants_of("light-off,"); }).sentence, "--variants has '': " + known);
}

TEST(TrackVariants, TheBaseHasTheThesisSettings) {
  Cloudscape cloudscape;
  cloudscape.medium.phase.kind = PhaseKind::two_lobe;
  cloudscape.view.march.structure = false;
  const FrameRequest request = track_request(cloudscape, {64, 36}, base);
  EXPECT_EQ(request.march.step_m, 20);
  EXPECT_EQ(request.march.large_step_m, 400);
  EXPECT_EQ(request.march.max_distance_m, 10000);
  EXPECT_GE(*request.march.step_m * *request.march.max_steps, request.march.max_distance_m);
  EXPECT_TRUE(request.march.structure && request.march.random_first_step && request.march.lighting);
  EXPECT_FALSE(request.march.adaptive_step || request.march.distance_field);
  EXPECT_EQ(request.cloudscape->medium.phase.kind, PhaseKind::henyey_greenstein);
  EXPECT_EQ(request.quality.march_divisor, 1);
  EXPECT_EQ(request.quality.samples, 1);
  EXPECT_FALSE(request.quality.smooth);
}

TEST(TrackVariants, AUnitIsTheCloudscapesOwnSmallStep) {
  Cloudscape cloudscape;
  cloudscape.view.march.step_m = 12.5;
  const March march = track_request(cloudscape, {64, 36}, base).march;
  EXPECT_EQ(march.step_m, 12.5);
  EXPECT_EQ(march.large_step_m, 250);
  EXPECT_EQ(march.max_distance_m, 6250);
  EXPECT_EQ(march.adaptive_start_m, 1250);
}

TEST(TrackVariants, EachChangesOneThing) {
  const FrameRequest first = track_request({}, {64, 36}, base);
  const auto changed = [&](TrackVariant variant) {
    const FrameRequest request = track_request({}, {64, 36}, variant);
    March march = request.march;
    Cloudscape cloudscape = *request.cloudscape;
    std::string names;
    const auto differs = [&](auto& mine, const auto& theirs, const char* name) {
      if (mine != theirs) names += name;
      mine = theirs;
    };
    differs(march.structure, first.march.structure, "structure");
    differs(march.distance_field, first.march.distance_field, "distances");
    differs(march.adaptive_step, first.march.adaptive_step, "adaptive");
    differs(march.lighting, first.march.lighting, "lighting");
    differs(cloudscape.medium.phase.kind, first.cloudscape->medium.phase.kind, "phase");
    EXPECT_EQ(march, first.march);
    EXPECT_EQ(cloudscape, *first.cloudscape);
    return names;
  };
  EXPECT_EQ(changed(structure_off), "structure");
  EXPECT_EQ(changed(distance_field), "distances");
  EXPECT_EQ(changed(adaptive_on), "adaptive");
  EXPECT_EQ(changed(light_off), "lighting");
  EXPECT_EQ(changed(phase_mie), "phase");
  EXPECT_EQ(changed(phase_none), "phase");
}

// Draws nothing, writes down what it was asked for, and takes as many ms as frames were asked for before.
struct Recorder {
  std::vector<FrameRequest> drawn;
  FrameSample operator()(const FrameRequest& request) {
    drawn.push_back(request);
    const auto count = static_cast<double>(drawn.size());
    return {count, 2 * count, 3 * count};
  }
};

TEST(TrackRun, DrawsVariantBesideVariantInTurningOrder) {
  Recorder recorder;
  std::vector<double> progress;
  const TrackRun run{4, 2, [&](double share) { progress.push_back(share); }};
  const TrackTimes track = run_track(path_of_40_s(), requests({base, structure_off, light_off}), run,
                                     [&](const FrameRequest& request) { return recorder(request); });
  EXPECT_THAT(track.time_s, ElementsAre(5, 15, 25, 35));
  EXPECT_EQ(track.size_px.width, 64);
  EXPECT_TRUE(track.base_march.structure);
  EXPECT_THAT(track.sections, ElementsAre("below", "below", "", "above"));
  EXPECT_THAT(progress, ElementsAre(0.25, 0.5, 0.75, 1));
  ASSERT_EQ(recorder.drawn.size(), (2u + 4) * (1 + 3));
  std::string order;
  for (std::size_t i = 8; i < recorder.drawn.size(); ++i) {
    const FrameRequest& request = recorder.drawn[i];
    order += request.size_px.width < 64 ? '|' : !request.march.structure ? 's' : !request.march.lighting ? 'l' : 'b';
    EXPECT_NEAR(request.pose.position_m.x, 10 * track.time_s[(i - 8) / 4], 1e-9);
    EXPECT_EQ(request.lens.vertical_fov_deg, 60);
    EXPECT_EQ(request.first_sample, 0);
  }
  EXPECT_EQ(order, "|bsl|slb|lbs|bsl");
  EXPECT_EQ(track.variants[0].frames[1], (FrameSample{16, 32, 48}));  // 8 warm-up, frames 9 to 12, then shared, s, l, b
  EXPECT_EQ(track.variants[1].frames[1].wall_ms, 14);
}

TEST(TrackStatistics, PairFrameWithFrame) {
  const std::vector<double> base_ms{1, 10, 4}, times_ms{2, 10, 12};
  EXPECT_THAT(ratios_of(times_ms, base_ms), ElementsAre(2, 1, 3));
  EXPECT_EQ(paired_ratio(times_ms, base_ms).median, 2);
  EXPECT_EQ(paired_ratio(times_ms, base_ms).of_means, 24.0 / 15);
  EXPECT_EQ(paired_ratio({1, 2}, {0, 0}).of_means, 0) << "a device without timers";
  EXPECT_EQ(paired_ratio({}, {}).median, 0);
  const Summary summary = summary_of({4, 1, 1});
  EXPECT_EQ(summary.mean_ms, 2);
  EXPECT_EQ(summary.median_ms, 1);
  EXPECT_EQ(summary.p95_ms, 4);
}

// Two frames below, one in no section, one above; the structure saves half below and nothing above.
TrackTimes made_up(bool device_timers = true) {
  const double device = device_timers ? 0.5 : 0;
  TrackTimes track{
      "sky", "track", {640, 360}, track_request({}, {}, base).march, {5, 15, 25, 35}, {"below", "below", "", "above"},
      {}};
  track.variants.push_back({base, {{20, 20 * device, 40}, {30, 30 * device, 60}, {10, 5, 20}, {40, 20, 80}}});
  track.variants.push_back(
      {structure_off, {{40, 40 * device, 80}, {60, 60 * device, 120}, {30, 15, 60}, {40, 20, 80}}});
  if (!device_timers)
    for (VariantTimes& variant : track.variants)
      for (FrameSample& frame : variant.frames) frame.device_ms = 0;
  return track;
}

std::string line_with(const std::string& text, const std::string& start) {
  const std::size_t begin = text.find("\n  " + start);
  return begin == std::string::npos ? "" : text.substr(begin + 1, text.find('\n', begin + 1) - begin - 1);
}

TEST(TrackTables, StandBesideTheThesis) {
  const std::string text = track_tables(made_up());
  EXPECT_THAT(text, HasSubstr("4 frames of 640x360 along track, of sky"));
  EXPECT_THAT(text, HasSubstr("steps of 20 and 400 m, to 10000 m; adaptive from 2000 m on"));
  EXPECT_THAT(text, HasSubstr("Table 3.1: preprocessed cloud structure"));
  EXPECT_THAT(line_with(text, "on "), testing::ContainsRegex("on +25.00 +20.00 +40.00 +12.50 +10.00 +20.00 .* 23.73$"));
  EXPECT_THAT(line_with(text, "off "), testing::ContainsRegex("off +42.50 +40.00 +60.00 .* 56.16$"));
  EXPECT_THAT(line_with(text, "off / on "), testing::ContainsRegex("off / on +1.700 +2.000 .* 2.367$"));
}

TEST(TrackTables, HaveOnlyWhatWasMeasured) {
  const std::string text = track_tables(made_up());
  for (const char* number : {"3.2", "3.3", "3.4"}) EXPECT_THAT(text, Not(HasSubstr(number)));
}

TEST(TrackTables, GiveMeansBySection) {
  const std::string text = track_tables(made_up());
  EXPECT_THAT(line_with(text, "base"), testing::ContainsRegex("base +25.00 \\( 1.000\\) +40.00 \\( 1.000\\)"));
  EXPECT_THAT(line_with(text, "structure-off"), testing::ContainsRegex("50.00 \\( 2.000\\) +40.00 \\( 1.000\\)"));
}

TEST(TrackJson, HoldsMachineTablesSectionsAndEveryFrame) {
  const auto json = nlohmann::json::parse(track_json(made_up(), {"llvmpipe", "4.5 Mesa", "fragment", 2}));
  EXPECT_EQ(json["benchmark"], "track");
  EXPECT_EQ(json["machine"]["renderer"], "llvmpipe");
  EXPECT_EQ(json["machine"]["cores"], 2);
  EXPECT_EQ(json["size_px"], (nlohmann::json{640, 360}));
  EXPECT_EQ(json["base_march"]["step_m"], 20);
  ASSERT_EQ(json["tables"].size(), 1u);
  const auto& off = json["tables"][0]["rows"][1];
  EXPECT_EQ(off["variant"], "structure-off");
  EXPECT_EQ(off["wall_over_base"]["of_means"], 1.7);
  EXPECT_NEAR(off["thesis_over_base"], 56.155690 / 23.728955, 1e-12);
  const auto& variant = json["variants"][1];
  EXPECT_EQ(variant["cpu"]["mean_ms"], 85);
  EXPECT_EQ(variant["sections"]["below"]["wall"]["mean_ms"], 50);
  EXPECT_EQ(variant["sections"]["below"]["wall"]["over_base"]["median_of_frames"], 2);
  EXPECT_EQ(variant["frames"]["wall_ms"], (nlohmann::json{40, 60, 30, 40}));
  EXPECT_EQ(json["frames"]["section"], (nlohmann::json{"below", "below", "", "above"}));
}

TEST(TrackFigures, AreOfWhatWasMeasured) {
  const auto figures = track_figures(made_up());
  ASSERT_EQ(figures.size(), 3u);
  EXPECT_EQ(figures[0].file, "figure-3.1-wall.svg");
  EXPECT_EQ(figures[1].file, "figure-3.1-device.svg");
  EXPECT_EQ(figures[2].file, "figure-3.1-cpu.svg");
  const LinePlot& plot = figures[0].plot;
  ASSERT_EQ(plot.lines.size(), 2u);
  EXPECT_THAT(plot.lines[1].y, ElementsAre(40, 60, 30, 40));
  ASSERT_EQ(plot.marks.size(), 2u);
  EXPECT_EQ(plot.marks[1].name, "above");
  EXPECT_EQ(plot.marks[1].x, 30);
  EXPECT_EQ(track_figures(made_up(false)).size(), 2u) << "no device times, no plot of them";
}

TEST(TrackFigures, InPlaceOfTheThesisPictureTheRatioOfTheCurves) {
  TrackTimes track = made_up();
  track.variants[1].variant = adaptive_on;
  const auto figures = track_figures(track);
  ASSERT_EQ(figures.size(), 6u);
  EXPECT_EQ(figures[1].file, "figure-3.3-wall.svg");
  EXPECT_THAT(figures[1].plot.lines[0].y, ElementsAre(2, 2, 3, 1));
}

}  // namespace
}  // namespace cloudscape::bench
