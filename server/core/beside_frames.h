// Long work beside the frames: on a thread of its own, which leaves the processors to those that render and encode,
// where somebody flies.
#pragma once
#include <atomic>
#include <future>
#include <utility>

namespace cloudscape {

// Whether frames wait for it, or go on with what was there before.
enum class Beside { awaited, lagging };

// While one lives, somebody flies. Without one nothing yields: what a still or a resting view waits for has no one in
// its way, and would wait for every other program of the machine.
class MovingPicture {
 public:
  MovingPicture() { ++count; }
  ~MovingPicture() { --count; }
  MovingPicture(const MovingPicture&) = delete;
  MovingPicture& operator=(const MovingPicture&) = delete;
  static bool anywhere() { return count > 0; }

 private:
  inline static std::atomic<int> count = 0;
};

// Of the calling thread and of those that it starts from now on; nothing while nobody flies.
void yield_to_frames(Beside beside = Beside::awaited);

// The future of `work()`; its destructor waits, as that of std::async.
template <class Work>
auto beside_frames(Work work, Beside beside = Beside::awaited) {
  return std::async(std::launch::async, [work = std::move(work), beside]() mutable {
    yield_to_frames(beside);
    return work();
  });
}

}  // namespace cloudscape
