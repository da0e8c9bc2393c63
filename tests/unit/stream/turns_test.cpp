// Who is next: streams among themselves, stills among them.
#include <map>

#include "scheduler_test.h"

namespace cloudscape::stream {
namespace {

class TurnsTest : public SchedulerTest {
 protected:
  std::optional<StreamId> submit() { return scheduler.submit_still({}, {}); }
  // Streams move all the time, stills take many turns: who was served in `turns` turns.
  std::vector<StreamId> serve(int turns, const std::vector<StreamId>& moving) {
    std::vector<StreamId> order;
    for (int i = 0; i < turns; ++i) {
      for (const StreamId stream : moving) scheduler.update(stream, looking(++azimuth));
      const auto work = take();
      if (!work) continue;
      order.push_back(work->request.stream);
      if (work->still) {
        pass(20);  // as long as a stream's frame
        EXPECT_TRUE(scheduler.yield(*work));
      } else {
        show(*work);
      }
    }
    return order;
  }
  static std::map<StreamId, int> count(const std::vector<StreamId>& order) {
    std::map<StreamId, int> counts;
    for (const StreamId id : order) ++counts[id];
    return counts;
  }
  double azimuth = 0;
};

TEST_F(TurnsTest, moving_streams_and_a_still_take_equal_turns) {
  std::vector<StreamId> streams;
  for (int i = 0; i < 9; ++i) streams.push_back(scheduler.open(looking(0)));
  const auto still = submit();
  const auto counts = count(serve(100, streams));
  for (const StreamId stream : streams) EXPECT_EQ(counts.at(stream), 10);
  EXPECT_EQ(counts.at(*still), 10);
}

TEST_F(TurnsTest, streams_have_half_of_the_turns_however_many_stills_there_are) {
  const auto stream = scheduler.open(looking(0));
  for (int i = 0; i < 10; ++i) submit();
  const auto order = serve(100, {stream});
  EXPECT_EQ(count(order).at(stream), 50);
  EXPECT_EQ(count(order).size(), 3u) << "two stills render at once, the others wait";
}

TEST_F(TurnsTest, stills_have_every_turn_that_no_stream_wants) {
  scheduler.open(looking(0));
  show_all();
  const auto first = submit(), second = submit();
  const auto counts = count(serve(40, {}));
  EXPECT_EQ(counts.at(*first), 20);
  EXPECT_EQ(counts.at(*second), 20);
}

TEST_F(TurnsTest, yielded_frame_comes_back_whole_after_the_others) {
  const auto first = scheduler.open(looking(1)), second = scheduler.open(looking(2));
  const auto work = take();
  EXPECT_EQ(work->request.stream, first);
  EXPECT_TRUE(scheduler.yield(*work));
  EXPECT_EQ(take()->request.stream, second);
  const auto again = take();
  ASSERT_TRUE(again);
  EXPECT_EQ(again->frame_id, work->frame_id);
  EXPECT_EQ(again->request.sequence, work->request.sequence);
  EXPECT_EQ(again->request.pose, work->request.pose);
  EXPECT_FALSE(take()) << "both are in render";
}

TEST_F(TurnsTest, stream_has_one_frame_in_render_however_often_it_moves) {
  const auto stream = scheduler.open(looking(0));
  const auto work = take();
  scheduler.update(stream, looking(1));
  EXPECT_FALSE(take());
  render(*work);
  EXPECT_EQ(take()->request.pose.azimuth_deg, 1) << "while the encoder has the frame before";
}

TEST_F(TurnsTest, encoder_that_lags_gets_no_third_frame) {
  const auto stream = scheduler.open(looking(0));
  widen(stream);
  const auto first = take();
  render(*first);
  scheduler.update(stream, looking(++azimuth));
  render(*take());
  scheduler.update(stream, looking(++azimuth));
  EXPECT_FALSE(take());
  scheduler.encoded(*first, 1, 1);
  EXPECT_TRUE(take());
}

TEST_F(TurnsTest, third_still_begins_when_one_ends) {
  submit();
  submit();
  const auto third = submit();
  const auto first_work = take(), second_work = take();
  EXPECT_FALSE(take());
  EXPECT_TRUE(scheduler.yield(*second_work));
  scheduler.rendered(*first_work, {});
  EXPECT_EQ(take()->request.stream, *third);
  EXPECT_EQ(metrics.value("cloudscape_frames_rendered_total{kind=\"still\"}"), 1);
}

TEST_F(TurnsTest, still_is_taken_as_it_was_submitted) {
  FrameRequest request;
  request.quality = render_quality(Quality::reference);
  request.content = FrameContent::radiance;
  request.sequence = 9;
  const Encoding encoding{ImageFormat::exr, 90, ChromaSubsampling::none, ExrType::float32};
  const auto still = scheduler.submit_still(request, encoding);
  const auto work = take();
  EXPECT_TRUE(work->still);
  EXPECT_EQ(work->request.stream, *still);
  EXPECT_EQ(work->request.sequence, 0u);
  EXPECT_EQ(work->request.quality, render_quality(Quality::reference));
  EXPECT_EQ(work->request.content, FrameContent::radiance);
  EXPECT_EQ(work->encoding, encoding);
  EXPECT_EQ(work->queued, now);
}

TEST_F(TurnsTest, full_queue_refuses_until_a_still_is_done_failed_or_cancelled) {
  std::vector<StreamId> ids;
  while (const auto id = submit()) ids.push_back(*id);
  EXPECT_EQ(ids.size(), SchedulerOptions{}.still_queue);
  EXPECT_EQ(scheduler.stills_waiting(), ids.size());
  EXPECT_EQ(metrics.value("cloudscape_stills_refused_total"), 1);
  scheduler.rendered(*take(), {});
  EXPECT_TRUE(submit());
  scheduler.failed(*take());
  EXPECT_TRUE(submit());
  scheduler.cancel_still(ids.back());
  EXPECT_TRUE(submit());
  EXPECT_FALSE(submit());
}

TEST_F(TurnsTest, cancelled_still_leaves_the_queue_or_ends_at_its_next_yield) {
  const auto rendering = submit(), waiting = submit();
  const auto work = take();
  scheduler.cancel_still(*waiting);
  scheduler.cancel_still(*rendering);
  scheduler.cancel_still(*rendering);
  EXPECT_FALSE(scheduler.wanted(*work));
  EXPECT_FALSE(scheduler.yield(*work));
  scheduler.rendered(*work, {});
  scheduler.encoded(*work, 1, 1);
  EXPECT_FALSE(take());
  EXPECT_EQ(scheduler.stills_waiting(), 0u);
  EXPECT_EQ(metrics.value("cloudscape_stills_cancelled_total"), 2);
  EXPECT_EQ(metrics.value("cloudscape_frames_rendered_total{kind=\"still\"}"), 0);
}

}  // namespace
}  // namespace cloudscape::stream
