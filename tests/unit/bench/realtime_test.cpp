// The judgement of moving pictures with a renderer that is made up: what it is asked for, and what comes out.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "bench/realtime_report.h"

namespace cloudscape::bench {
namespace {

using testing::HasSubstr;

settings::CameraPath path_of_40_s() {
  return settings::parse_camera_path(R"({"keys": [
      {"time_s": 0, "pose": {"position_m": [0, 0, 100]}, "vertical_fov_deg": 60},
      {"time_s": 40, "pose": {"position_m": [400, 0, 100]}, "vertical_fov_deg": 60}]})",
                                     "path");
}

// Grey pictures: the truth 100, moving ones 100 plus what the test says of the how-manieth.
struct GreyRenderer {
  std::function<int(std::size_t)> error = [](std::size_t) { return 0; };
  std::vector<FrameRequest> moving, truths;
  std::vector<StreamId> forgotten;

  Frame draw(const FrameRequest& request) {
    const bool moves = request.light_may_lag;
    const int value = 100 + (moves ? error(moving.size()) : 0);
    (moves ? moving : truths).push_back(request);
    Frame frame;
    frame.request = request;
    frame.display_rgba.assign(std::size_t(4) * request.size_px.width * request.size_px.height,
                              static_cast<std::uint8_t>(value));
    if (request.time_passes) frame.timings.passes = {{"march", 3, 5}, {"tone_map", 1, 2}};
    return frame;
  }
  QualityRun run() {
    QualityRun run;
    run.view.size_px = {16, 9};
    run.flicker_size_px = {8, 8};
    run.path = path_of_40_s();
    run.detail = 3;
    run.legs = 4;
    run.draw = [this](const FrameRequest& request) { return draw(request); };
    run.forget = [this](StreamId stream) { forgotten.push_back(stream); };
    return run;
  }
};

TEST(MovingLegs, LieEvenlyOrAreTheWholePath) {
  const auto legs = legs_of(10, 50, 1.0 / 30, 4);
  ASSERT_EQ(legs.size(), 4u);
  EXPECT_EQ(legs[1].begin_s, 20);
  EXPECT_EQ(legs[1].frames, 30);
  const auto whole = legs_of(10, 50, 1.0 / 30, 1000);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].begin_s, 10);
  EXPECT_EQ(whole[0].frames, 1200);
  EXPECT_TRUE(legs_of(10, 50, 1.0 / 30, 0).empty());
  EXPECT_EQ(legs_of(10, 10, 1.0 / 30, 5)[0].frames, 1) << "a path of one key";
}

TEST(MovingQuality, AsksForWhatAMovingStreamAsksFor) {
  GreyRenderer renderer;
  QualityRun run = renderer.run();
  run.flicker_frames = 0;
  const MovingQuality quality = judge_moving(run);
  ASSERT_EQ(renderer.moving.size(), 120u);
  ASSERT_EQ(renderer.truths.size(), 12u);
  for (std::size_t i = 0; i < renderer.moving.size(); ++i) {
    const FrameRequest& request = renderer.moving[i];
    EXPECT_EQ(request.sequence, i);
    EXPECT_EQ(request.stream, renderer.moving[0].stream);
    EXPECT_EQ(request.quality.reuse, 4);
    EXPECT_EQ(request.quality.resolution_divisor, 2);
    EXPECT_EQ(request.quality.samples, 1);
    EXPECT_NEAR(request.lens.vertical_fov_deg, 60, 1e-9);
    EXPECT_NEAR(request.pose.position_m.x, 100.0 * static_cast<double>(i / 30) + static_cast<double>(i % 30) / 3, 1e-6);
  }
  const FrameRequest& truth = renderer.truths[0];
  EXPECT_EQ(truth.pose, renderer.moving[9].pose);
  EXPECT_NE(truth.stream, renderer.moving[0].stream);
  EXPECT_EQ(truth.quality.reuse, 1);
  EXPECT_EQ(truth.quality.resolution_divisor, 1);
  EXPECT_EQ(truth.quality.samples, 16);
  EXPECT_FALSE(truth.quality.smooth || truth.display.dither || truth.time_passes);
  EXPECT_EQ(truth.quality.max_steps, render_quality(Quality::interactive).max_steps);
  ASSERT_EQ(quality.passes.size(), 2u);
  EXPECT_EQ(quality.passes[0].ms, 360);
}

TEST(MovingQuality, IsPerfectWhereMovingFramesAreTheTruth) {
  GreyRenderer renderer;
  const MovingQuality quality = judge_moving(renderer.run());
  const QualityFigures figures = figures_of(quality.compared);
  EXPECT_EQ(figures.flip_worst, 0);
  EXPECT_EQ(figures.psnr_worst_db, 100);
  EXPECT_EQ(quality.still.mean_percent, 0);
  EXPECT_EQ(quality.pan.mean_percent, 0);
  EXPECT_EQ(quality.pan.frames, 60);
}

TEST(MovingQuality, FindsTheFrameThatIsWrongAndTheFlicker) {
  GreyRenderer renderer;
  renderer.error = [](std::size_t i) { return i == 19 ? 40 : i < 120 ? 0 : i % 2 ? 3 : -3; };
  const MovingQuality quality = judge_moving(renderer.run());
  EXPECT_EQ(quality.compared[0].flip, 0);
  EXPECT_GT(quality.compared[1].flip, 0.1);
  EXPECT_NEAR(quality.compared[1].psnr_db, 20 * std::log10(255.0 / 40), 1e-6);
  EXPECT_NEAR(quality.compared[1].time_s, 19 / 30.0, 1e-9);
  const double expected_percent = 100 * 6.0 / 255 / std::sqrt(1.5);
  EXPECT_NEAR(quality.still.mean_percent, expected_percent, 1e-6);
  EXPECT_NEAR(quality.pan.mean_percent, expected_percent, 1e-6);
}

TEST(MovingQuality, TurnsTheCameraForThePanOnly) {
  GreyRenderer renderer;
  QualityRun run = renderer.run();
  run.legs = 0;
  run.flicker_at_s = 20;
  judge_moving(run);
  ASSERT_EQ(renderer.moving.size(), 140u);
  ASSERT_EQ(renderer.truths.size(), 60u);
  EXPECT_EQ(renderer.moving[69].pose, renderer.moving[0].pose);
  EXPECT_NEAR(renderer.moving[139].pose.azimuth_deg - renderer.moving[109].pose.azimuth_deg, pan_deg_per_s, 1e-9);
  EXPECT_EQ(renderer.moving[139].pose.position_m.x, 200);
  EXPECT_EQ(renderer.truths[59].pose, renderer.moving[139].pose);
  EXPECT_EQ(renderer.moving[0].size_px, (ImageSize{8, 8}));
  EXPECT_THAT(renderer.forgotten, testing::SizeIs(4)) << "before each camera, and at the end both streams";
}

TEST(RealtimeReport, HoldsWhatWasMeasured) {
  GreyRenderer renderer;
  RealtimeResults results;
  results.cloudscape = "sky", results.path = "track", results.size_px = {16, 9}, results.speed_m_per_s = 120;
  results.flight = figures_of({{0, 50, 20, 15, 1, 2, 2048, 3}, {40, 50, 20, 15, 1, 2, 2048, 3}}, 1);
  results.cpu_ms = 33, results.threads = {{"llvmpipe", 30}};
  results.judged = renderer.run();
  results.quality = judge_moving(results.judged);
  const std::string text = realtime_table(results);
  for (const char* part :
       {"16x9, sky along track at 120 m/s, 2 frames in 1.0 s", "1 in 4 pixels marched, of a picture kept at 1/2",
        "llvmpipe 30.0", "2.0 KiB", "march                         3.00      5.00    75.0 %",
        "tone_map                      1.00      2.00    25.0 %", "67 px a degree", "slow pan"})
    EXPECT_THAT(text, HasSubstr(part));
  const auto json = nlohmann::json::parse(realtime_json(results, {"llvmpipe", "4.5 Mesa", "fragment", 2}));
  EXPECT_EQ(json["flight"]["interval"]["median_ms"], 40);
  EXPECT_EQ(json["flight"]["cpu_ms_per_frame_of_threads"]["llvmpipe"], 30);
  EXPECT_EQ(json["quality"]["compared"].size(), 12u);
  EXPECT_EQ(json["quality"]["passes"][0]["share"], 0.75);
  EXPECT_EQ(json["quality"]["passes"][0]["ms_per_frame"], 3);
  EXPECT_EQ(json["quality"]["passes"][0]["cpu_ms_per_frame"], 5);
  EXPECT_EQ(json["quality"]["flicker"]["pan"]["frames"], 60);
}

TEST(RealtimeReport, SaysWhenNoPassIsTimed) {
  RealtimeResults results;
  results.quality.emplace().compared.push_back({0, 0.1, 30});
  EXPECT_THAT(realtime_table(results), HasSubstr("passes                     not told by the renderer"));
}

}  // namespace
}  // namespace cloudscape::bench
