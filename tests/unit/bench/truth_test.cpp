// The comparison with the truth: what is chosen, rendered, kept, added up and told.
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "bench/truth_pictures.h"
#include "bench/truth_report.h"
#include "bench/truth_run.h"
#include "core/error.h"

namespace cloudscape::bench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::path fresh_folder(const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / ("truth-" + name);
  fs::remove_all(folder);
  return folder;
}

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

std::vector<TruthView> views_of(const std::string& names) {
  return truth_views_of(names, settings::CloudscapeLibrary({}));
}

TEST(TruthModels, EveryKindHasALineAndOneIsTheDefault) {
  std::vector<LightModelKind> kinds;
  int defaults = 0;
  for (const TruthModel& model : truth_models()) kinds.push_back(model.light.kind), defaults += model.is_default();
  for (std::size_t i = 0; i < EnumNames<LightModelKind>::names.size(); ++i)
    EXPECT_THAT(kinds, testing::Contains(static_cast<LightModelKind>(i)));
  EXPECT_EQ(defaults, 1);
}

TEST(TruthModels, AreChosenByName) {
  const auto models = truth_models_of("olajos,single,olajos");
  ASSERT_EQ(models.size(), 2);
  EXPECT_STREQ(models[0].name, "single") << "in the table's order, each once";
  EXPECT_THAT(refusal([] { truth_models_of("single,beer-octave"); }),
              testing::AllOf(HasSubstr("--models"), HasSubstr("did you mean beer-octaves?")));
  EXPECT_NE(refusal([] { truth_models_of(""); }), "");
}

TEST(TruthViews, CoverWhatTheyMust) {
  const auto views = views_of("all");
  EXPECT_GE(views.size(), 9);
  bool low = false, high = false, above = false;
  for (const TruthView& view : views) {
    const Cloudscape& sky = *view.request.cloudscape;
    // Next to the forward peak of Mie theory no reference converges in minutes.
    EXPECT_EQ(sky.medium.phase.kind, PhaseKind::henyey_greenstein) << view.name;
    low |= sky.sun.elevation_deg >= 5 && sky.sun.elevation_deg <= 10;
    high |= sky.sun.elevation_deg >= 60;
    above |= view.request.pose.position_m.z > sky.volume.origin_m.z + sky.volume.size_m.z;
    EXPECT_FALSE(view.request.display.dither) << view.name;
    EXPECT_EQ(view.request.display.bloom_strength, 0) << view.name;
    EXPECT_FALSE(view.description.empty()) << view.name;
  }
  EXPECT_TRUE(low && high && above);
  EXPECT_THAT(refusal([] { views_of("noom"); }), testing::AllOf(HasSubstr("--views"), HasSubstr("noon")));
}

TEST(ReferenceKey, DependsOnWhatThePixelsDependOn) {
  const FrameRequest view = views_of("noon").front().request;
  const FrameRequest reference = reference_request(view, {16, 9}, 4, 1);
  EXPECT_EQ(reference.quality.technique, Technique::path_tracing);
  const std::string key = reference_key(reference);
  EXPECT_NE(reference_key(reference_request(view, {16, 8}, 4, 1)), key);
  EXPECT_NE(reference_key(reference_request(view, {16, 9}, 5, 1)), key);
  EXPECT_NE(reference_key(reference_request(view, {16, 9}, 4, 2)), key);
  FrameRequest turned = reference;
  turned.pose.azimuth_deg += 1;
  EXPECT_NE(reference_key(turned), key);
  FrameRequest thicker = reference;
  auto sky = std::make_shared<Cloudscape>(*view.cloudscape);
  sky->medium.extinction_per_m *= 2;
  thicker.cloudscape = sky;
  EXPECT_NE(reference_key(thicker), key);
}

TEST(ReferenceKey, DoesNotDependOnModelAndExposure) {
  const FrameRequest reference = reference_request(views_of("noon").front().request, {16, 9}, 4, 1);
  FrameRequest other = reference;
  auto sky = std::make_shared<Cloudscape>(*reference.cloudscape);
  sky->medium.light_model.kind = LightModelKind::olajos;
  sky->view.display.exposure_ev = 9;
  other.cloudscape = sky;
  other.display.exposure_ev = 9;
  EXPECT_EQ(reference_key(other), reference_key(reference));
}

// A grey picture; the reference is half cloud, and each model's grey is its kind's.
Frame grey_frame(const FrameRequest& request) {
  const bool traced = request.quality.technique == Technique::path_tracing;
  const float grey = traced ? 0.2F : 0.2F + 0.02F * static_cast<float>(request.cloudscape->medium.light_model.kind);
  Frame frame;
  frame.request = request;
  const int pixels = request.size_px.width * request.size_px.height;
  for (int i = 0; i < pixels; ++i)
    for (const float value : {grey, grey, grey, i < pixels / 2 ? 1.0F : 0.0F}) frame.radiance_rgba.push_back(value);
  frame.depth_m.assign(pixels, 1000.0F);
  if (traced) frame.standard_error_rgb.assign(3 * pixels, 0.01F);
  return frame;
}

struct Counts {
  int traced = 0, marched = 0, drawn = 0;
};

TruthRun tiny_run(const fs::path& references, Counts& counts) {
  TruthRun run;
  run.views = views_of("noon,overcast");
  run.models = truth_models_of("single,beer-octaves");
  run.size_px = {16, 8};
  run.reference_samples = 2;
  run.references = KeptReferences(references);
  run.render = [&counts](const FrameRequest& request) {
    ++(request.quality.technique == Technique::path_tracing ? counts.traced : counts.marched);
    return grey_frame(request);
  };
  // A frame after a change of the sun costs 9 ms more than one at rest.
  run.draw = [&counts, elevation_deg = 0.0](const FrameRequest& request) mutable {
    ++counts.drawn;
    const double before_deg = std::exchange(elevation_deg, request.cloudscape->sun.elevation_deg);
    return FrameSample{5, 0, before_deg == elevation_deg ? 4.0 : 13.0};
  };
  return run;
}

TEST(TruthRun, ComparesEveryModelInEveryView) {
  Counts counts;
  const fs::path folder = fresh_folder("run");
  const TruthResults results = run_truth(tiny_run(folder, counts));
  ASSERT_EQ(results.views.size(), 2);
  EXPECT_EQ(counts.traced, 2);
  EXPECT_EQ(counts.marched, 4);
  const ViewResult& view = results.views.front();
  EXPECT_NEAR(view.cloud_share, 0.5, 1e-9);
  EXPECT_NEAR(view.reference_noise, 0.05, 1e-6);
  EXPECT_NEAR(view.noise_floor.clouds.mean, 0.8 * 0.05, 0.008) << "sqrt(2 / pi), of a normal distribution";
  EXPECT_GT(view.noise_floor.ldr_flip, 0);
  const ModelResult& single = view.models[0];
  EXPECT_EQ(single.ldr_flip, 0);
  EXPECT_EQ(single.hdr_flip, 0);
  EXPECT_EQ(single.psnr_db, 100);
  const ModelResult& octaves = view.models[1];
  EXPECT_EQ(octaves.clouds.pixels, 64);
  EXPECT_EQ(octaves.whole.pixels, 128);
  EXPECT_EQ(octaves.tiles.pixels, 2) << "each of which is half cloud";
  EXPECT_NEAR(octaves.tiles.mean, 0.2, 1e-5);
  EXPECT_LT(view.noise_floor.tiles.mean, view.noise_floor.clouds.mean / 3);
  EXPECT_NEAR(octaves.clouds.mean, 0.2, 1e-5);
  EXPECT_NEAR(octaves.clouds.log_ratio, std::log(1.2), 1e-5);
  EXPECT_GT(octaves.ldr_flip, 0);
  EXPECT_EQ(octaves.cost->cpu_ms, 4);
  EXPECT_EQ(octaves.cost->wall_ms, 5);
  EXPECT_EQ(octaves.cost->sun_change_cpu_ms, 9);
}

TEST(TruthRun, KeepsReferences) {
  Counts counts;
  const fs::path folder = fresh_folder("kept");
  TruthRun run = tiny_run(folder, counts);
  const TruthResults first = run_truth(run);
  run.cost_frames = 0;
  const TruthResults second = run_truth(run);
  EXPECT_EQ(counts.traced, 2) << "once each";
  EXPECT_EQ(second.views[1].models[1].clouds.mean, first.views[1].models[1].clouds.mean);
  EXPECT_EQ(second.views[1].reference_noise, first.views[1].reference_noise);
  EXPECT_FALSE(second.views[1].models[1].cost);
}

TEST(TruthRun, TellsADamagedReference) {
  Counts counts;
  const fs::path folder = fresh_folder("damaged");
  TruthRun run = tiny_run(folder, counts);
  run_truth(run);
  for (const auto& file : fs::directory_iterator(folder)) std::ofstream(file.path()) << "none";
  EXPECT_THROW(run_truth(run), Error);
}

TEST(TruthRun, WritesPicturesAndMaps) {
  Counts counts;
  const fs::path folder = fresh_folder("pictures");
  TruthRun run = tiny_run(folder, counts);
  run.pictures = folder;
  run_truth(run);
  for (const char* file : {"noon-reference.png", "overcast-single.png", "overcast-beer-octaves-flip.png"})
    EXPECT_GT(fs::file_size(folder / file), 50) << file;
}

TEST(FlipMap, GoesFromBlackToWhite) {
  const Picture map = flip_map({0, 1.0 / 6, 0.5, 1}, {4, 1});
  EXPECT_EQ(map.rgb[0], glm::dvec3(0, 0, 0));
  EXPECT_EQ(map.rgb[1], glm::dvec3(1, 0, 0));
  EXPECT_EQ(map.rgb[2], glm::dvec3(1, 1, 1));
  EXPECT_EQ(map.rgb[3], glm::dvec3(1, 1, 1));
}

ModelResult model_result(const std::string& name, double error, double log_ratio, double flip) {
  ModelResult result;
  result.model = name;
  result.clouds = {error, 2 * error, log_ratio, 10};
  result.whole.mean = error / 2;
  result.ldr_flip = flip, result.hdr_flip = 2 * flip, result.psnr_db = 30 - 100 * flip;
  result.cost = TruthCost{10 * flip, 1, 100 * flip};
  return result;
}

ViewResult view_result(const std::string& name, const std::string& title, const std::string& description) {
  ViewResult view;
  view.name = name, view.title = title, view.description = description;
  view.cloud_share = 0.5, view.reference_noise = 0.01;
  view.noise_floor = model_result("noise", 0.008, 0, 0.001);
  return view;
}

TruthResults two_views() {
  TruthResults results;
  results.size_px = {256, 144};
  results.default_model = "right";
  results.views = {view_result("noon", "Noon", "High <sun>"), view_result("dusk", "Dusk", "Low sun")};
  results.views[0].models = {model_result("right", 0.1, -0.14, 0.05), model_result("wrong", 0.3, 0.1, 0.1)};
  results.views[1].models = {model_result("right", 0.18, 0.1, 0.1), model_result("wrong", 0.1, -0.6, 0.2)};
  return results;
}

TEST(TruthSummary, TakesMeansAndTheWorstView) {
  const auto summaries = summaries_of(two_views());
  ASSERT_EQ(summaries.size(), 2);
  const ModelSummary& right = summaries[0];
  EXPECT_DOUBLE_EQ(right.relative_error, 0.14);
  EXPECT_DOUBLE_EQ(right.abs_log_ratio, 0.12);
  EXPECT_DOUBLE_EQ(right.worst_abs_log_ratio.value, 0.14);
  EXPECT_EQ(right.worst_abs_log_ratio.view, "noon");
  EXPECT_EQ(right.worst_ldr_flip.view, "dusk");
  EXPECT_DOUBLE_EQ(right.worst_psnr_db.value, 20);
  EXPECT_EQ(right.worst_psnr_db.view, "dusk");
  EXPECT_DOUBLE_EQ(right.cost->sun_change_cpu_ms, 7.5);
}

TEST(TruthSummary, HoldsModelsToTheTargets) {
  const auto summaries = summaries_of(two_views());
  for (const TruthTarget& target : truth_targets()) {
    EXPECT_TRUE(target.met(summaries[0])) << target.name;
    EXPECT_FALSE(target.met(summaries[1])) << target.name;
  }
  EXPECT_TRUE(summaries_of(TruthResults{}).empty());
  EXPECT_EQ(noise_floor_of(TruthResults{}).model, "");
  EXPECT_DOUBLE_EQ(noise_floor_of(two_views()).relative_error, 0.008);
}

TEST(TruthReport, TablesNameModelsViewsAndTargets) {
  const std::string text = truth_tables(two_views());
  for (const char* part : {"256x144", "the reference's own noise.\n", "noon: Noon", "18.0%", "-0.140", "0.0500",
                           "right (default) 0.140 met", "wrong 0.600 MISSED", "0.140 noon"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST(TruthReport, JsonHoldsEveryFigure) {
  const auto json = nlohmann::json::parse(truth_json(two_views(), {"llvmpipe", "4.5", "fragment", 2}));
  EXPECT_EQ(json["benchmark"], "truth");
  const auto& model = json["views"][1]["models"][1];
  EXPECT_EQ(model["model"], "wrong");
  EXPECT_EQ(model["clouds"]["log_ratio_of_means"], -0.6);
  EXPECT_EQ(model["ldr_flip"], 0.2);
  EXPECT_EQ(json["views"][0]["noise_floor"]["ldr_flip"], 0.001);
  EXPECT_EQ(model["cost"]["frame_wall_ms"], 1);
  EXPECT_EQ(json["summary"][0]["worst"]["ldr_flip"]["view"], "dusk");
  EXPECT_EQ(json["summary"][1]["targets"][1]["met"], false);
}

TEST(TruthReport, PageShowsEveryPictureAndEscapesText) {
  const std::string page = truth_html(two_views(), {"llvmpipe", "4.5", "fragment", 2});
  for (const char* file :
       {"noon-reference.png", "dusk-wrong.png", "dusk-wrong-flip.png", "noon-right.png", "dusk-noise-flip.png"})
    EXPECT_THAT(page, HasSubstr("src=\"" + std::string(file) + "\""));
  EXPECT_THAT(page, HasSubstr("High &lt;sun&gt;"));
  EXPECT_THAT(page, HasSubstr("right (default)"));
}

}  // namespace
}  // namespace cloudscape::bench
