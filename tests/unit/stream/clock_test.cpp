// Clocks with a fake time: what they show, and what a view that only a clock moves is given.
#include "scheduler_test.h"
#include "stream/shared_clock.h"

namespace cloudscape::stream {
namespace {

constexpr Time start{std::chrono::hours(5)};
Time after(double seconds) { return start + ms(1000 * seconds); }

TEST(SharedClock, StandsAtFirst) {
  const SharedClock clock;
  EXPECT_EQ(clock.read(start), (ClockState{0, 1, true}));
  EXPECT_EQ(clock.read(after(1000)), (ClockState{0, 1, true}));
}

TEST(SharedClock, RunsFromWhereItIsAtItsRate) {
  SharedClock clock;
  clock.change({100, 10, false}, start);
  EXPECT_NEAR(clock.read(after(3)).time_s, 130, 1e-9);
  clock.change({{}, 60, {}}, after(3));
  EXPECT_NEAR(clock.read(after(3)).time_s, 130, 1e-9) << "another rate is no jump";
  EXPECT_NEAR(clock.read(after(5)).time_s, 250, 1e-9);
  clock.change({{}, {}, true}, after(5));
  EXPECT_NEAR(clock.read(after(500)).time_s, 250, 1e-9);
  EXPECT_EQ(clock.read(after(500)).rate, 60) << "which it goes on with";
  clock.change({{}, {}, false}, after(500));
  EXPECT_NEAR(clock.read(after(501)).time_s, 310, 1e-9);
  clock.change({7, {}, {}}, after(501));
  EXPECT_NEAR(clock.read(after(502)).time_s, 67, 1e-9) << "it runs on from where it was put";
  clock.change({}, after(502));
  EXPECT_NEAR(clock.read(after(502)).time_s, 67, 1e-9);
}

TEST(SharedClock, RunsBackwardsAndStopsAtItsLimits) {
  SharedClock clock;
  clock.change({{}, -3600, false}, start);
  EXPECT_NEAR(clock.read(after(2)).time_s, -7200, 1e-6);
  EXPECT_EQ(clock.read(after(1e6)).time_s, -longest_time_s);
  EXPECT_EQ(clock.running().at(after(1e6)), clock.read(after(1e6)).time_s) << "streams see what it tells";
}

class ClockedView : public SchedulerTest {
 protected:
  StreamView clocked(double time_s, double rate, double azimuth_deg = 0) {
    StreamView view = looking(azimuth_deg, Quality::draft);
    view.clock = RunningTime{time_s, rate, now};
    return view;
  }
};

TEST_F(ClockedView, MovesAtTheTargetRateWhileTheClockRuns) {
  const Time begin = now;
  scheduler.open(clocked(500, 10));
  int frames = 0;
  double last_s = 0;
  for (; now < begin + ms(2000); pass(1))
    if (const auto work = take()) {
      EXPECT_EQ(work->quality_stage, 0);
      EXPECT_NEAR(work->request.time_s, 500 + 10 * std::chrono::duration<double>(now - begin).count(), 1e-9);
      EXPECT_GT(work->request.time_s, last_s);
      last_s = work->request.time_s;
      show(*work, 5);
      ++frames;
    }
  EXPECT_NEAR(frames, 2000 / whole_frames().target_frame_ms, 2);
}

TEST_F(ClockedView, RestsAndIsRefinedOnceTheClockStands) {
  const StreamId stream = scheduler.open(clocked(500, 10));
  show(*take());
  pass(1000);
  scheduler.update(stream, clocked(510, 0));
  const std::vector<Work> works = show_all();
  ASSERT_GT(works.size(), 1U);
  for (const Work& work : works) EXPECT_EQ(work.request.time_s, 510);
  EXPECT_EQ(works.front().quality_stage, 0);
  EXPECT_EQ(works.back().quality_stage, 255);
  EXPECT_FALSE(take()) << "a clock that stands costs nothing";
}

TEST_F(ClockedView, IsNoLongerRefinedOnceTheClockRuns) {
  const StreamId stream = scheduler.open(clocked(0, 0));
  show(*take());
  pass(300);
  const auto refining = take();
  ASSERT_TRUE(refining);
  EXPECT_GT(refining->quality_stage, 0);
  scheduler.update(stream, clocked(0, 1));
  EXPECT_FALSE(scheduler.yield(*refining));
  EXPECT_EQ(take()->quality_stage, 0);
}

TEST_F(ClockedView, AnswersACameraAtOnce) {
  const StreamId stream = scheduler.open(clocked(0, 1));
  show(*take(), 1);
  EXPECT_FALSE(take()) << "the next is not due";
  StreamView turned = clocked(0, 1, 30);
  scheduler.update(stream, turned);
  EXPECT_EQ(take()->request.pose.azimuth_deg, 30);
}

TEST_F(ClockedView, GetsNoMoreThanItAcknowledges) {
  scheduler.open(clocked(0, 60));
  int frames = 0;
  for (int i = 0; i < 100; ++i, pass(60))
    if (const auto work = take()) send(*work), ++frames;
  EXPECT_LE(frames, 3);
}

TEST_F(ClockedView, TwoShowTheSameTime) {
  const StreamView view = clocked(20, 30);
  scheduler.open(view);
  scheduler.open(view);
  pass(400);
  const auto one = take(), other = take();
  ASSERT_TRUE(one && other);
  EXPECT_NE(one->request.stream, other->request.stream);
  EXPECT_NEAR(one->request.time_s, 32, 1e-9);
  EXPECT_EQ(one->request.time_s, other->request.time_s);
}

TEST_F(ClockedView, CostsNothingWhereNobodyLooks) {
  const StreamId stream = scheduler.open(clocked(0, 60));
  scheduler.close(stream);
  pass(1000);
  EXPECT_FALSE(take());
}

}  // namespace
}  // namespace cloudscape::stream
