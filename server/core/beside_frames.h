// Long work beside the frames: on a thread of its own, which leaves the processors to those that render and encode.
#pragma once
#include <future>
#include <utility>

namespace cloudscape {

// Of the calling thread and of those that it starts from now on.
void yield_to_frames();

// The future of `work()`; its destructor waits, as that of std::async.
template <class Work>
auto beside_frames(Work work) {
  return std::async(std::launch::async, [work = std::move(work)]() mutable {
    yield_to_frames();
    return work();
  });
}

}  // namespace cloudscape
