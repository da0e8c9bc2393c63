// Frames of the background: the turns that nobody else wants, and few of those that somebody wants.
#include <map>

#include "scheduler_test.h"

namespace cloudscape::stream {
namespace {

class BackgroundTest : public SchedulerTest {
 protected:
  StreamId submit() { return *scheduler.submit_background({}, {}); }
  // A viewer flies for `seconds`: what is taken is rendered for 40 ms, and a frame is acknowledged 30 ms later. Returns
  // the slices that each was given.
  std::map<StreamId, int> fly(StreamId stream, double seconds) {
    std::map<StreamId, int> slices;
    const Time end = now + ms(1000 * seconds);
    for (double azimuth = 0; now < end; ++azimuth) {
      scheduler.update(stream, looking(azimuth));
      const auto work = take();
      pass(work ? 40 : 1);
      if (!work) continue;
      ++slices[work->request.stream];
      if (work->still) {
        EXPECT_TRUE(scheduler.yield(*work));
        continue;
      }
      scheduler.rendered(*work, {});
      scheduler.encoded(*work, 40'000, 0);
      pass(30);
      scheduler.acknowledge(stream, work->frame_id, 0);
    }
    return slices;
  }
};

TEST_F(BackgroundTest, is_rendered_when_nobody_else_is_there) {
  const StreamId first = submit(), second = submit();
  const auto work = take();
  ASSERT_TRUE(work);
  EXPECT_EQ(work->request.stream, first);
  EXPECT_TRUE(work->still);
  EXPECT_TRUE(scheduler.wanted(*work));
  EXPECT_TRUE(scheduler.yield(*work));
  EXPECT_EQ(take()->request.stream, first) << "what is begun is finished first";
  render(*work);
  EXPECT_EQ(take()->request.stream, second);
  EXPECT_EQ(metrics.value("cloudscape_frames_rendered_total{kind=\"background\"}"), 1);
  EXPECT_EQ(metrics.value("cloudscape_stills_waiting"), 0);
}

TEST_F(BackgroundTest, costs_a_flying_viewer_one_slice_in_two_seconds) {
  const StreamId stream = scheduler.open(looking(0));
  const StreamId job = submit();
  const auto slices = fly(stream, 20);
  EXPECT_GE(slices.at(job), 8) << "a job goes on however long somebody flies";
  EXPECT_LE(slices.at(job), 11);
  EXPECT_GE(slices.at(stream), 270) << "of 285 without the background";
}

TEST_F(BackgroundTest, stills_go_first) {
  const StreamId job = submit();
  const auto begun = take();
  EXPECT_TRUE(scheduler.yield(*begun));
  const auto still = scheduler.submit_still({}, {});
  for (int slice = 0; slice < 10; ++slice) {
    const auto work = take();
    ASSERT_TRUE(work);
    EXPECT_EQ(work->request.stream, *still);
    pass(60);
    EXPECT_TRUE(scheduler.yield(*work));
  }
  scheduler.rendered(*take(), {});
  EXPECT_FALSE(take()) << "not in the pause after another's frame";
  pass(250);
  EXPECT_EQ(take()->request.stream, job);
}

TEST_F(BackgroundTest, cancelled_frame_leaves_or_ends_at_its_next_yield) {
  const StreamId rendering = submit(), waiting = submit();
  const auto work = take();
  scheduler.cancel_still(waiting);
  scheduler.cancel_still(rendering);
  EXPECT_FALSE(scheduler.wanted(*work));
  EXPECT_FALSE(scheduler.yield(*work));
  EXPECT_FALSE(take());
  EXPECT_EQ(metrics.value("cloudscape_stills_cancelled_total"), 0);
}

TEST_F(BackgroundTest, failed_frame_is_forgotten_and_nothing_is_taken_after_stop) {
  submit();
  scheduler.failed(*take());
  EXPECT_EQ(dropped("failed"), 1);
  EXPECT_FALSE(take());
  scheduler.stop();
  EXPECT_FALSE(scheduler.submit_background({}, {}));
}

}  // namespace
}  // namespace cloudscape::stream
