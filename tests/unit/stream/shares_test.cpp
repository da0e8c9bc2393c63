// Shares of the renderer's time: a viewer who asks for large frames does not take them from the others.
#include <map>

#include "scheduler_test.h"
#include "stream/quality_control.h"

namespace cloudscape::stream {
namespace {

// What a stream's frames cost, and what it was given.
struct Cost {
  double slice_ms = 20;
  int slices = 1;
};
struct Given {
  int frames = 0;
  Time last{};
  double longest_ms = 0;  // from frame to frame
};

class SharesTest : public SchedulerTest {
 protected:
  StreamId open(const Cost& cost) {
    const StreamId stream = scheduler.open(looking(0));
    costs[stream] = cost;
    given[stream].last = now;
    return stream;
  }
  void move_all() {
    for (const auto& [stream, cost] : costs)
      if (scheduler.is_open(stream)) scheduler.update(stream, looking(++azimuth));
  }
  void finish(const Work& work, const FrameTimings& timings) {
    scheduler.rendered(work, timings);
    scheduler.encoded(work, 40'000, 0);
    scheduler.acknowledge(work.request.stream, work.frame_id, 0);
    Given& its = given[work.request.stream];
    ++its.frames;
    its.longest_ms = std::max(its.longest_ms, std::chrono::duration<double, std::milli>(now - its.last).count());
    its.last = now;
  }
  // Everybody moves all the time; a software renderer.
  void fly(double seconds) {
    for (const Time end = now + ms(1000 * seconds); now < end;) {
      move_all();
      const auto work = take();
      if (!work) {
        pass(1);
        continue;
      }
      const Cost cost = costs.at(work->request.stream);
      pass(cost.slice_ms);
      if (++done[work->request.stream] % cost.slices != 0)
        scheduler.yield(*work);
      else if (work->still)
        scheduler.rendered(*work, {});
      else
        finish(*work, {.render_ms = cost.slice_ms * cost.slices});
    }
  }
  // The same with a device that works through what it is given, one after the other, while the render thread only
  // submits (0.1 ms a slice) and waits for the frame before the last.
  void fly_on_device(double seconds) {
    struct Submitted {
      Work work;
      double device_ms;
      Time ready;
    };
    std::optional<Submitted> pending;
    std::map<StreamId, Time> begun;
    Time device_free = now;
    const auto collect = [&] {
      if (pending->ready > now) now = pending->ready;
      finish(pending->work, {.render_ms = 0.1, .gpu_ms = pending->device_ms});
      pending.reset();
    };
    for (const Time end = now + ms(1000 * seconds); now < end;) {
      move_all();
      const auto work = take();
      if (work) {
        const StreamId stream = work->request.stream;
        const Cost cost = costs.at(stream);
        pass(0.1);
        device_free = std::max(device_free, now);
        if (done[stream] % cost.slices == 0) begun[stream] = device_free;
        device_free += ms(cost.slice_ms);
        if (++done[stream] % cost.slices != 0) {
          scheduler.yield(*work);
        } else {
          if (pending) collect();
          const double device_ms = std::chrono::duration<double, std::milli>(device_free - begun[stream]).count();
          pending = {*work, device_ms, device_free};
        }
      }
      if (pending && (!work || pending->ready <= now)) collect();
      if (!work) pass(0.1);
    }
  }
  double frames_per_second(StreamId stream, double seconds) { return given.at(stream).frames / seconds; }

  std::map<StreamId, Cost> costs;
  std::map<StreamId, Given> given;
  std::map<StreamId, int> done;  // slices
  double azimuth = 0;
};

// Four share the renderer: a quarter of the 50 frames a second that a small one could have alone, and of the 2.5 that
// the large one could. Between two frames of a small one: a slice of the large one, or two, and the other two.
TEST_F(SharesTest, one_that_asks_for_4k_leaves_the_others_their_quarter) {
  const StreamId large = open({60, 7});  // 3840x2160, 400 ms
  std::vector<StreamId> small;
  for (int i = 0; i < 3; ++i) small.push_back(open({20, 1}));
  fly(30);
  for (const StreamId stream : small) {
    EXPECT_GE(frames_per_second(stream, 30), 12);
    EXPECT_LE(given.at(stream).longest_ms, 60 + 3 * 20);
  }
  EXPECT_GE(frames_per_second(large, 30), 0.9 * 0.25 * 1000 / 420) << "nor do they starve it";
}

TEST_F(SharesTest, time_that_nobody_else_wants_is_the_large_ones) {
  const StreamId large = open({60, 7});
  fly(10);
  EXPECT_GE(frames_per_second(large, 10), 2.3);
}

// The target is 50 ms; a frame takes 20, whatever its detail.
TEST_F(SharesTest, detail_is_what_all_who_move_can_have_in_their_turns) {
  const auto detail_of = [&](StreamId stream) {
    for (int i = 0; i < 1000; ++i, pass(1)) {
      scheduler.update(stream, looking(++azimuth));
      const auto work = take();
      if (!work) continue;
      finish(*work, {.render_ms = 20});
      if (work->request.stream == stream) return moving_detail_of(work->request.quality);
    }
    return -1;
  };
  const StreamId first = open({20, 1});
  fly(3);
  EXPECT_EQ(detail_of(first), 0) << "alone it has the finest";
  for (int i = 0; i < 3; ++i) open({20, 1});
  fly(3);
  EXPECT_GE(detail_of(first), 3) << "four take 80 ms for a frame of each";
  while (costs.size() > 1) {
    scheduler.close(std::prev(costs.end())->first);
    costs.erase(std::prev(costs.end()));
  }
  fly(30);
  EXPECT_EQ(detail_of(first), 0) << "and alone again, it has it again";
}

TEST_F(SharesTest, a_device_that_works_on_after_the_slice_is_shared_alike) {
  const StreamId large = open({20, 8});
  std::vector<StreamId> small;
  for (int i = 0; i < 3; ++i) small.push_back(open({2, 1}));
  fly_on_device(30);
  for (const StreamId stream : small) {
    EXPECT_GE(frames_per_second(stream, 30), 0.8 * 0.25 * 1000 / 2);
    EXPECT_LE(given.at(stream).longest_ms, 200) << "a frame of the large one, at the most";
  }
  EXPECT_GE(frames_per_second(large, 30), 0.8 * 0.25 * 1000 / 160);
}

TEST_F(SharesTest, who_wanted_nothing_saves_nothing_up) {
  const StreamId resting = open({20, 1}), busy = open({20, 1});
  fly(1);
  const Cost cost = costs.extract(resting).mapped();
  for (int i = 0; i < 300; ++i) {  // `resting` is refined to the end, and then wants nothing
    scheduler.update(busy, looking(++azimuth));
    if (const auto work = take()) show(*work);
  }
  costs[resting] = cost;
  const int busy_before = given.at(busy).frames, resting_before = given.at(resting).frames;
  fly(2);
  EXPECT_NEAR(given.at(busy).frames - busy_before, given.at(resting).frames - resting_before, 2);
}

TEST_F(SharesTest, all_stills_together_have_the_share_of_one_stream) {
  const StreamId stream = open({20, 1});
  for (int i = 0; i < 6; ++i) costs[*scheduler.submit_still({}, {})] = {60, 1000};
  fly(10);
  EXPECT_NEAR(frames_per_second(stream, 10), 25, 1.5);
}

}  // namespace
}  // namespace cloudscape::stream
