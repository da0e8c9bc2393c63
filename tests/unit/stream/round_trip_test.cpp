// How many frames may be in flight, from what the acknowledgements tell.
#include "stream/round_trip.h"

#include "scheduler_test.h"

namespace cloudscape::stream {
namespace {

RoundTrip::Sample alone(double transit_ms) { return {transit_ms, 0, true, {}}; }
RoundTrip::Sample queued(double transit_ms, double interval_ms) { return {transit_ms, 0, false, interval_ms}; }

RoundTrip with(double round_trip_ms, double render_ms) {
  RoundTrip round_trip;
  round_trip.produced(render_ms, 2);
  round_trip.acknowledged(alone(round_trip_ms));
  round_trip.acknowledged(queued(round_trip_ms, 1));
  return round_trip;
}

TEST(RoundTripTest, window_is_two_before_anything_is_known) {
  EXPECT_EQ(RoundTrip().window(3), 2);
  EXPECT_EQ(RoundTrip().window(1), 1);
  RoundTrip round_trip;
  round_trip.produced(10, 2);
  round_trip.acknowledged(alone(300));
  EXPECT_EQ(round_trip.window(8), 2) << "a long way or a slow link?";
}

TEST(RoundTripTest, window_covers_the_round_trip_with_frames_and_is_bounded) {
  EXPECT_EQ(with(5, 50).window(8), 2);
  EXPECT_EQ(with(80, 50).window(8), 3);
  EXPECT_EQ(with(180, 50).window(8), 5);
  EXPECT_EQ(with(5000, 50).window(3), 3);
  EXPECT_EQ(with(5000, 50).window(1), 1);
}

TEST(RoundTripTest, slow_link_counts_as_the_slowest_stage) {
  RoundTrip round_trip = with(60, 10);
  for (int i = 0; i < 20; ++i) round_trip.acknowledged(queued(110, 55));
  EXPECT_NEAR(round_trip.frame_ms(), 55, 1);
  EXPECT_EQ(round_trip.window(3), 2) << "a third frame would only queue";
}

TEST(RoundTripTest, queue_is_what_a_frame_takes_longer_than_one_alone) {
  RoundTrip round_trip = with(60, 10);
  EXPECT_EQ(round_trip.acknowledged(queued(100, 50)), 40);
  EXPECT_EQ(round_trip.acknowledged(alone(70)), 0);
  EXPECT_GT(round_trip.ms(), 60);
}

TEST(RoundTripTest, queue_that_never_empties_is_probed_with_one_frame_alone) {
  RoundTrip round_trip = with(60, 50);
  int acknowledged = 0;
  while (round_trip.window(3) > 1 && acknowledged < 1000) {
    round_trip.acknowledged(queued(400, 50));
    ++acknowledged;
  }
  EXPECT_EQ(acknowledged, 40);
  round_trip.acknowledged(alone(300));  // the way did become longer
  EXPECT_EQ(round_trip.ms(), 300);
  EXPECT_EQ(round_trip.window(3), 3);
}

class WindowTest : public SchedulerTest {};

TEST_F(WindowTest, viewer_that_never_acknowledges_gets_two_frames_and_costs_nothing_more) {
  const auto silent = scheduler.open(looking(0)), answering = scheduler.open(looking(0));
  int frames_of_silent = 0, frames_of_answering = 0;
  for (int i = 1; i <= 1000; ++i, pass(10)) {
    scheduler.update(silent, looking(i));
    scheduler.update(answering, looking(i));
    while (const auto work = take()) {
      work->request.stream == silent ? ++frames_of_silent : ++frames_of_answering;
      send(*work);
      scheduler.acknowledge(answering, work->frame_id, 0);
    }
  }
  EXPECT_EQ(frames_of_silent, 2);
  EXPECT_EQ(frames_of_answering, 1000);
  EXPECT_EQ(metrics.value("cloudscape_frames_in_flight"), 2);
}

TEST_F(WindowTest, acknowledgement_retires_all_frames_before_and_others_are_ignored) {
  const auto stream = scheduler.open(looking(0));
  const auto first = take();
  send(*first);
  scheduler.update(stream, looking(1));
  const auto second = take();
  send(*second);
  scheduler.acknowledge(stream, 99, 0);
  scheduler.acknowledge(stream + 1000, second->frame_id, 0);
  EXPECT_EQ(metrics.value("cloudscape_frames_in_flight"), 2);
  scheduler.acknowledge(stream, second->frame_id, 0);
  scheduler.acknowledge(stream, first->frame_id, 0);
  scheduler.acknowledge(stream, second->frame_id, 0);
  EXPECT_EQ(metrics.value("cloudscape_frames_in_flight"), 0);
}

TEST_F(WindowTest, acknowledgement_in_advance_is_ignored) {
  const auto stream = scheduler.open(looking(0));
  const auto work = take();
  scheduler.acknowledge(stream, work->frame_id, 0);
  send(*work);
  EXPECT_EQ(metrics.value("cloudscape_frames_in_flight"), 1);
}

TEST_F(WindowTest, decoding_is_no_part_of_the_round_trip_whatever_the_viewer_claims) {
  for (const double decode_ms : {30.0, -5.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    const auto stream = scheduler.open(looking(0));
    const auto work = take();
    send(*work);
    pass(100);
    scheduler.acknowledge(stream, work->frame_id, decode_ms);
    EXPECT_NEAR(scheduler.stats(stream).round_trip_ms, decode_ms == 30 ? 70 : decode_ms == 1e300 ? 0 : 100, 1e-6);
    scheduler.close(stream);
  }
}

TEST_F(WindowTest, motion_behind_a_refined_frame_tells_nothing_of_the_way) {
  const auto stream = scheduler.open(looking(0));
  show(*take());
  ASSERT_EQ(scheduler.stats(stream).round_trip_ms, 0);
  pass(200);
  const auto refined = take();
  send(*refined);
  scheduler.update(stream, looking(1));
  const auto moving = take();
  send(*moving);
  pass(3000);
  scheduler.acknowledge(stream, refined->frame_id, 0);
  scheduler.acknowledge(stream, moving->frame_id, 0);
  scheduler.update(stream, looking(2));
  EXPECT_EQ(take()->encoding.jpeg_quality, 78);
  EXPECT_EQ(scheduler.stats(stream).round_trip_ms, 0);
}

TEST_F(WindowTest, stalled_viewer_with_drops_is_not_rendered_for_without_end) {
  const auto stream = scheduler.open(looking(0));
  widen(stream);
  std::optional<Work> waiting;  // behind the frame that fills the socket
  send(*take());
  int frames = 0;
  for (int i = 0; i < 100; ++i, ++frames) {
    scheduler.update(stream, looking(100 + i));
    const auto work = take();
    if (!work) break;
    send(*work);
    if (waiting) scheduler.dropped(stream, waiting->frame_id);
    waiting = work;
  }
  EXPECT_LE(frames, 3);
  EXPECT_EQ(scheduler.stats(stream).frames_dropped, static_cast<std::uint64_t>(dropped("replaced")));
  EXPECT_GE(dropped("replaced"), 1);
}

TEST_F(WindowTest, dropped_frame_leaves_the_window_once) {
  const auto stream = scheduler.open(looking(0));
  const auto work = take();
  send(*work);
  scheduler.dropped(stream, work->frame_id);
  scheduler.dropped(stream, work->frame_id);
  scheduler.dropped(stream, 77);
  EXPECT_EQ(dropped("replaced"), 1);
  EXPECT_EQ(metrics.value("cloudscape_frames_in_flight"), 0);
}

}  // namespace
}  // namespace cloudscape::stream
