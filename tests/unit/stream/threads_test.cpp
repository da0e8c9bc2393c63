// All threads of the server at once, on the real clock; ThreadSanitizer watches, the assertions count.
#include <atomic>
#include <random>
#include <thread>

#include "scheduler_test.h"

namespace cloudscape::stream {
namespace {

class ThreadsTest : public SchedulerTest {
 protected:
  FrameScheduler real{whole_frames(), metrics};
  std::atomic<bool> running = true;
  std::atomic<int> frames = 0, twice = 0;
  std::array<std::atomic<int>, 1024> in_render{};

  void render_thread(unsigned seed) {
    std::mt19937 random(seed);
    while (running) {
      const auto work = real.take(std::chrono::steady_clock::now() + ms(5));
      if (!work) continue;
      auto& mine = in_render[work->request.stream % in_render.size()];
      twice += mine++ != 0;
      const auto dice = random() % 8;
      --mine;
      if (dice == 0) {
        real.failed(*work);
      } else if (dice < 3) {
        real.yield(*work);
      } else {
        real.rendered(*work, {});
        real.encoded(*work, 1000, 1);
        if (dice == 3) real.dropped(work->request.stream, work->frame_id);
        if (dice > 3) real.acknowledge(work->request.stream, work->frame_id, 1);
        ++frames;
      }
    }
  }

  void network_thread(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<StreamId> streams, stills;
    while (running) {
      std::this_thread::sleep_for(std::chrono::microseconds(200));
      if (streams.size() < 4) streams.push_back(real.open(looking(0)));
      const StreamId stream = streams[random() % streams.size()];
      real.update(stream, looking(static_cast<double>(random() % 100)));
      (void)real.stats(stream);
      if (const auto still = real.submit_still({}, {}); still && random() % 2) real.cancel_still(*still);
      if (random() % 50 == 0) {
        real.close(stream);
        std::erase(streams, stream);
      }
    }
    for (const StreamId stream : streams) real.close(stream);
  }
};

TEST_F(ThreadsTest, nobody_is_rendered_twice_at_once_and_everything_ends) {
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < 2; ++i) {
    threads.emplace_back([this, i] { render_thread(i); });
    threads.emplace_back([this, i] { network_thread(i + 10); });
  }
  const auto end = std::chrono::steady_clock::now() + ms(60'000);  // of a machine that has no time for us
  do std::this_thread::sleep_for(ms(600));
  while (frames <= 100 && std::chrono::steady_clock::now() < end);
  running = false;
  real.stop();
  for (std::thread& thread : threads) thread.join();
  EXPECT_GT(frames, 100);
  EXPECT_EQ(twice, 0);
  EXPECT_EQ(metrics.value("cloudscape_streams_open"), 0);
  EXPECT_EQ(metrics.value("cloudscape_frames_in_flight"), 0);
}

}  // namespace
}  // namespace cloudscape::stream
