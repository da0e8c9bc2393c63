// What a viewer gets while it moves and when it rests.
#include "stream/refinement.h"

#include "scheduler_test.h"

namespace cloudscape::stream {
namespace {

struct Expected {
  int first_sample, samples, stage, jpeg_quality;
  ChromaSubsampling chroma;
};

void expect_refining(const Work& work, const Expected& expected) {
  EXPECT_EQ(work.request.first_sample, expected.first_sample);
  EXPECT_EQ(work.request.quality.samples, expected.samples);
  EXPECT_EQ(work.quality_stage, expected.stage);
  EXPECT_EQ(work.encoding, (Encoding{ImageFormat::jpeg, expected.jpeg_quality, expected.chroma}));
}

class RefinementTest : public SchedulerTest {};

TEST_F(RefinementTest, first_frame_answers_at_once_and_coarsely) {
  scheduler.open(looking(30));
  const auto work = take();
  ASSERT_TRUE(work);
  EXPECT_EQ(work->quality_stage, 0);
  EXPECT_EQ(work->request.quality, render_quality(Quality::interactive));
  EXPECT_EQ(work->encoding, (Encoding{ImageFormat::jpeg, 78, ChromaSubsampling::half}));
  EXPECT_EQ(work->request.pose.azimuth_deg, 30);
}

TEST_F(RefinementTest, resting_view_doubles_its_samples_and_then_falls_silent) {
  scheduler.open(looking(0));
  const auto works = show_all();
  ASSERT_EQ(works.size(), 5u);
  EXPECT_EQ(works[0].quality_stage, 0);
  constexpr auto half = ChromaSubsampling::half, none = ChromaSubsampling::none;
  expect_refining(works[1], {0, 1, 1, 85, half});
  expect_refining(works[2], {1, 1, 2, 87, half});
  expect_refining(works[3], {2, 2, 3, 89, half});
  expect_refining(works[4], {4, 4, 255, 95, none});
  for (std::size_t i = 0; i < works.size(); ++i) EXPECT_EQ(works[i].request.sequence, i);
}

TEST_F(RefinementTest, rest_begins_150_ms_after_the_last_change) {
  const auto stream = scheduler.open(looking(0));
  show(*take());
  pass(50);
  scheduler.update(stream, looking(1));
  show(*take(), 20);
  pass(129);
  EXPECT_FALSE(take());
  pass(1);
  const auto work = take();
  ASSERT_TRUE(work);
  EXPECT_EQ(work->quality_stage, 1);
  EXPECT_EQ(work->request.quality.max_steps, render_quality(Quality::standard).max_steps);
}

TEST_F(RefinementTest, next_motion_waits_behind_one_refined_frame_at_most) {
  const auto stream = scheduler.open(looking(0));
  const auto moving = take();
  send(*moving);
  pass(200);
  EXPECT_FALSE(take());
  scheduler.acknowledge(stream, moving->frame_id, 0);
  send(*take());
  EXPECT_FALSE(take());
  scheduler.update(stream, looking(1));
  EXPECT_TRUE(take());
}

class EveryQuality : public RefinementTest, public testing::WithParamInterface<Quality> {};

TEST_P(EveryQuality, steps_add_up_and_only_the_last_is_final) {
  const int wanted = render_quality(GetParam()).samples;
  scheduler.open(looking(0, GetParam()));
  const auto works = show_all();
  int accumulated = 0, jpeg_quality = 0;
  for (std::size_t i = 1; i < works.size(); ++i) {
    EXPECT_EQ(works[i].request.first_sample, accumulated);
    accumulated += works[i].request.quality.samples;
    EXPECT_EQ(works[i].request.quality.march_divisor, 1);
    EXPECT_EQ(works[i].quality_stage == 255, accumulated == wanted);
    EXPECT_GE(works[i].encoding.jpeg_quality, jpeg_quality);
    jpeg_quality = works[i].encoding.jpeg_quality;
  }
  EXPECT_EQ(accumulated, wanted);
  EXPECT_EQ(jpeg_quality, 95);
}

INSTANTIATE_TEST_SUITE_P(All, EveryQuality,
                         testing::Values(Quality::draft, Quality::interactive, Quality::standard, Quality::high,
                                         Quality::finest));

TEST_F(RefinementTest, newest_view_wins) {
  const auto stream = scheduler.open(looking(0));
  for (int i = 1; i <= 5; ++i) {
    StreamView view = looking(i);
    view.pose_sequence = i;
    scheduler.update(stream, view);
  }
  const auto work = take();
  EXPECT_EQ(work->request.pose.azimuth_deg, 5);
  EXPECT_EQ(work->pose_sequence, 5u);
  show(*work);
  EXPECT_FALSE(take());
}

TEST_F(RefinementTest, new_pose_sequence_alone_renders_nothing_but_is_kept) {
  const auto stream = scheduler.open(looking(0));
  show_all();
  StreamView view = looking(0);
  view.cloudscape = std::make_shared<const Cloudscape>();  // another document of the same content
  view.pose_sequence = 7;
  scheduler.update(stream, view);
  EXPECT_TRUE(show_all().empty());
  view.display.exposure_ev = 1;
  scheduler.update(stream, view);
  EXPECT_EQ(take()->pose_sequence, 7u);
}

TEST_F(RefinementTest, everything_that_changes_the_picture_is_motion) {
  const StreamView start = looking(0);
  std::vector<StreamView> others(7, start);
  others[0].lens.vertical_fov_deg = 20;
  others[1].display.exposure_ev = 1;
  others[2].size_px.width = 320;
  others[3].time_s = 1;
  others[4].quality = Quality::high;
  others[5].pose.position_m.z = 3;
  Cloudscape seeded;
  seeded.seed = 2;
  others[6].cloudscape = std::make_shared<const Cloudscape>(seeded);
  const auto stream = scheduler.open(start);
  for (const StreamView& view : others) {
    show_all();
    scheduler.update(stream, view);
    const auto work = take();
    ASSERT_TRUE(work);
    EXPECT_EQ(work->quality_stage, 0);
    show(*work);
    scheduler.update(stream, start);
  }
}

TEST_F(RefinementTest, motion_abandons_a_refinement_and_the_average_starts_anew) {
  const auto stream = scheduler.open(looking(0));
  show(*take());
  pass(200);
  show(*take());
  const auto refining = take();
  EXPECT_EQ(refining->request.first_sample, 1);
  EXPECT_TRUE(scheduler.wanted(*refining));
  scheduler.update(stream, looking(1));
  EXPECT_FALSE(scheduler.wanted(*refining));
  EXPECT_FALSE(scheduler.yield(*refining));
  EXPECT_EQ(dropped("abandoned"), 1);
  const auto moving = take();
  EXPECT_EQ(moving->quality_stage, 0);
  EXPECT_EQ(moving->request.pose.azimuth_deg, 1);
  show(*moving);
  pass(200);
  EXPECT_EQ(take()->request.first_sample, 0);
}

TEST_F(RefinementTest, view_that_comes_back_after_an_abandoned_step_refines_from_its_first_sample) {
  const auto stream = scheduler.open(looking(0));
  show(*take());
  pass(200);
  show(*take());
  const auto refining = take();
  scheduler.update(stream, looking(1));
  EXPECT_FALSE(scheduler.yield(*refining));
  scheduler.update(stream, looking(0));
  EXPECT_FALSE(take()) << "the viewer has a frame of this view";
  pass(200);
  EXPECT_EQ(take()->request.first_sample, 0);
}

TEST_F(RefinementTest, yielded_refinement_is_abandoned_by_the_update_itself) {
  const auto stream = scheduler.open(looking(0));
  show(*take());
  pass(200);
  const auto refining = take();
  EXPECT_TRUE(scheduler.yield(*refining));
  scheduler.update(stream, looking(1));
  EXPECT_FALSE(scheduler.wanted(*refining));
  EXPECT_EQ(take()->quality_stage, 0);
}

TEST_F(RefinementTest, stale_refinement_that_is_rendered_is_sent_and_its_successor_moves) {
  const auto stream = scheduler.open(looking(0));
  show(*take());
  pass(200);
  const auto refining = take();
  scheduler.update(stream, looking(1));
  show(*refining);
  EXPECT_EQ(dropped("abandoned"), 0);
  EXPECT_EQ(take()->quality_stage, 0);
}

TEST_F(RefinementTest, viewer_that_never_rests_sees_every_frame_that_was_begun) {
  const auto stream = scheduler.open(looking(0));
  for (int i = 1; i <= 20; ++i) {
    const auto work = take();
    ASSERT_TRUE(work);
    scheduler.update(stream, looking(i));
    ASSERT_TRUE(scheduler.yield(*work)) << "in slices";
    pass(300);  // long enough to look like rest
    const auto again = take();
    ASSERT_TRUE(again);
    EXPECT_EQ(again->frame_id, work->frame_id);
    EXPECT_EQ(again->quality_stage, 0);
    show(*again);
  }
}

TEST_F(RefinementTest, failed_view_waits_for_another) {
  const auto stream = scheduler.open(looking(0));
  scheduler.failed(*take());
  EXPECT_TRUE(show_all().empty());
  StreamView same = looking(0);
  same.pose_sequence = 3;
  scheduler.update(stream, same);
  EXPECT_TRUE(show_all().empty());
  scheduler.update(stream, looking(1));
  EXPECT_EQ(show_all().size(), 5u);
  EXPECT_EQ(dropped("failed"), 1);
}

TEST_F(RefinementTest, frame_that_the_encoder_loses_leaves_the_window_and_ends_the_refinement) {
  const auto stream = scheduler.open(looking(0));
  const auto work = take();
  render(*work);
  scheduler.failed(*work);
  EXPECT_EQ(metrics.value("cloudscape_frames_in_flight"), 0);
  EXPECT_TRUE(show_all().empty());
  scheduler.update(stream, looking(1));
  EXPECT_TRUE(take());
}

// With reuse a frame marches a part of the picture, and the rest of it follows when the view has come to rest.
TEST(SteadyingTest, picture_is_whole_before_it_is_refined) {
  Time now{};
  Metrics metrics;
  FrameScheduler scheduler({}, metrics, [&] { return now; });
  StreamView view;
  view.cloudscape = std::make_shared<const Cloudscape>();
  const auto stream = scheduler.open(view);
  int moving = 0;
  std::optional<Work> work;
  while ((work = scheduler.take(now)) && work->quality_stage == moving_stage) {
    ++moving;
    EXPECT_EQ(work->request.quality.reuse, 4);
    now += ms(20);
    FrameTimings timings;
    timings.render_ms = 20;
    scheduler.rendered(*work, timings);
    scheduler.encoded(*work, 40'000, 0);
    scheduler.acknowledge(stream, work->frame_id, 0);
  }
  EXPECT_EQ(moving, 4);
  EXPECT_FALSE(work) << "80 ms later it has not rested long enough to be refined";
  now += ms(70);
  work = scheduler.take(now);
  ASSERT_TRUE(work);
  EXPECT_EQ(work->quality_stage, 1);
  EXPECT_EQ(work->request.quality.reuse, 1);
  EXPECT_EQ(work->request.quality.resolution_divisor, 1);
}

}  // namespace
}  // namespace cloudscape::stream
