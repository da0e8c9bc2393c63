// Opening, closing, stopping, and what is told about it.
#include <chrono>
#include <thread>

#include "core/beside_frames.h"
#include "scheduler_test.h"

namespace cloudscape::stream {
namespace {

class LifecycleTest : public SchedulerTest {};

TEST_F(LifecycleTest, stream_closed_in_render_makes_its_work_harmless) {
  const auto stream = scheduler.open(looking(0));
  const auto work = take();
  EXPECT_TRUE(scheduler.wanted(*work));
  scheduler.close(stream);
  scheduler.close(stream);
  EXPECT_FALSE(scheduler.wanted(*work));
  EXPECT_FALSE(scheduler.yield(*work));
  scheduler.rendered(*work, {});
  scheduler.encoded(*work, 10, 1);
  scheduler.failed(*work);
  scheduler.update(stream, looking(1));
  scheduler.acknowledge(stream, work->frame_id, 0);
  scheduler.dropped(stream, work->frame_id);
  EXPECT_FALSE(take());
  EXPECT_EQ(scheduler.stats(stream).window, 0);
  EXPECT_EQ(metrics.value("cloudscape_frames_rendered_total{kind=\"stream\"}"), 0);
  EXPECT_EQ(metrics.value("cloudscape_frames_in_flight"), 0);
}

TEST_F(LifecycleTest, closing_one_stream_takes_no_turn_from_the_others) {
  const auto first = scheduler.open(looking(0)), second = scheduler.open(looking(0)),
             third = scheduler.open(looking(0));
  EXPECT_EQ(take()->request.stream, first);
  scheduler.close(second);
  EXPECT_EQ(take()->request.stream, third);
  EXPECT_FALSE(take());
}

TEST_F(LifecycleTest, ids_of_streams_and_stills_are_never_used_twice) {
  const auto stream = scheduler.open(looking(0));
  const auto still = scheduler.submit_still({}, {});
  scheduler.close(stream);
  scheduler.cancel_still(*still);
  FrameScheduler other(whole_frames(), metrics);
  EXPECT_GT(*still, stream);
  EXPECT_GT(other.open(looking(0)), *still);
}

TEST_F(LifecycleTest, work_that_is_reported_twice_counts_once) {
  scheduler.open(looking(0));
  const auto work = take();
  send(*work);
  send(*work);
  EXPECT_EQ(metrics.value("cloudscape_frames_rendered_total{kind=\"stream\"}"), 1);
  EXPECT_EQ(metrics.value("cloudscape_frames_in_flight"), 1);
}

TEST_F(LifecycleTest, late_word_of_an_old_frame_leaves_the_one_in_render_alone) {
  const auto stream = scheduler.open(looking(0));
  const auto old = take();
  send(*old);
  scheduler.update(stream, looking(1));
  const auto work = take();
  EXPECT_FALSE(scheduler.yield(*old));
  scheduler.rendered(*old, {});
  EXPECT_FALSE(take());
  EXPECT_TRUE(scheduler.yield(*work));
  EXPECT_FALSE(scheduler.yield(*old));
  EXPECT_EQ(take()->frame_id, work->frame_id);
  scheduler.failed(*old);
  EXPECT_TRUE(scheduler.wanted(*work));
}

TEST_F(LifecycleTest, stats_tell_the_last_two_seconds) {
  const auto stream = scheduler.open(looking(0));
  for (int i = 0; i < 100; ++i) {
    scheduler.update(stream, looking(i));
    const auto work = take();
    ASSERT_TRUE(work);
    send(*work, 20, 5000);
    pass(30);
    scheduler.acknowledge(stream, work->frame_id, 10);
  }
  const StreamStats stats = scheduler.stats(stream);
  EXPECT_NEAR(stats.frames_per_second, 20, 0.5);
  EXPECT_NEAR(stats.bits_per_second, 20 * 5000 * 8, 20'000);
  EXPECT_NEAR(stats.round_trip_ms, 20, 1e-6);
  EXPECT_EQ(stats.render_ms, 20);
  EXPECT_EQ(stats.window, 2);
  pass(3000);
  EXPECT_EQ(scheduler.stats(stream).frames_per_second, 0);
}

TEST_F(LifecycleTest, gauges_and_histograms_follow) {
  const auto stream = scheduler.open(looking(0));
  scheduler.submit_still({}, {});
  EXPECT_EQ(metrics.value("cloudscape_streams_open"), 1);
  EXPECT_EQ(metrics.value("cloudscape_stills_waiting"), 1);
  show(*take());
  scheduler.close(stream);
  EXPECT_EQ(metrics.value("cloudscape_streams_open"), 0);
  const std::string text = metrics.prometheus_text();
  for (const char* histogram : {"queue", "render", "encode", "ack"})
    EXPECT_NE(text.find("cloudscape_" + std::string(histogram) + "_ms_count 1\n"), std::string::npos) << histogram;
}

// Long work yields to them: core/beside_frames.h.
TEST_F(LifecycleTest, flies_from_its_first_moving_frame_until_it_is_refined_or_closed) {
  const auto stream = scheduler.open(looking(0));
  const auto work = take();
  EXPECT_FALSE(MovingPicture::anywhere());
  show(*work);
  EXPECT_TRUE(MovingPicture::anywhere());
  show_all();
  EXPECT_FALSE(MovingPicture::anywhere());
  scheduler.update(stream, looking(1));
  show(*take());
  EXPECT_TRUE(MovingPicture::anywhere());
  scheduler.close(stream);
  EXPECT_FALSE(MovingPicture::anywhere());
}

TEST_F(LifecycleTest, nothing_is_taken_or_wanted_after_stop) {
  scheduler.open(looking(0));
  scheduler.open(looking(0));
  const auto work = take();
  scheduler.stop();
  EXPECT_FALSE(take());
  EXPECT_FALSE(scheduler.wanted(*work));
  EXPECT_FALSE(scheduler.yield(*work));
  EXPECT_FALSE(scheduler.submit_still({}, {}));
}

// On the real clock.
class WaitingTest : public SchedulerTest {
 protected:
  FrameScheduler real{whole_frames(), metrics};
  static Time in(double time_ms) { return std::chrono::steady_clock::now() + ms(time_ms); }
};

TEST_F(WaitingTest, take_returns_at_its_deadline) {
  const Time deadline = in(20);
  EXPECT_FALSE(real.take(deadline));
  EXPECT_GE(std::chrono::steady_clock::now(), deadline);
}

TEST_F(WaitingTest, take_wakes_for_a_new_stream_and_for_rest) {
  std::thread viewer([&] {
    std::this_thread::sleep_for(ms(10));
    real.open(looking(0));
  });
  const auto moving = real.take(Time::max());
  viewer.join();
  ASSERT_TRUE(moving);
  real.rendered(*moving, {});
  real.encoded(*moving, 1, 1);
  real.acknowledge(moving->request.stream, moving->frame_id, 0);
  const auto refining = real.take(Time::max());
  ASSERT_TRUE(refining);
  EXPECT_EQ(refining->quality_stage, 1);
}

TEST_F(WaitingTest, stop_wakes_take) {
  std::thread stopper([&] {
    std::this_thread::sleep_for(ms(10));
    real.stop();
  });
  EXPECT_FALSE(real.take(Time::max()));
  stopper.join();
}

}  // namespace
}  // namespace cloudscape::stream
