// Long work beside the frames: on a thread of its own, which leaves the processors to those that render and encode.
#pragma once
#include <future>
#include <utility>

namespace cloudscape {

// Whether frames wait for it, or go on with what was there before.
enum class Beside { awaited, lagging };

// Of the calling thread and of those that it starts from now on.
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
