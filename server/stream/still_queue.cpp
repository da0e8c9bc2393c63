#include "stream/still_queue.h"

#include <algorithm>
#include <utility>

#include "stream/refinement.h"

namespace cloudscape::stream {
namespace {

// tuned: a small still need not wait for the large one before it, and the GPU holds the targets of two at most.
constexpr int rendering_at_once = 2;

}  // namespace

void StillQueue::submit(StreamId id, FrameRequest request, const Encoding& encoding, Time now) {
  Work work;
  work.request = std::move(request);
  work.request.stream = id;
  work.request.sequence = 0;
  work.request.first_sample = 0;
  work.encoding = encoding;
  work.still = true;
  work.quality_stage = final_stage;
  work.queued = now;
  stills_.emplace(id, Still{std::move(work)});
}

bool StillQueue::ready(StreamId id) const {
  const auto still = stills_.find(id);
  if (still == stills_.end() || still->second.state == State::rendering) return false;
  const auto begun =
      std::ranges::count_if(stills_, [](const auto& each) { return each.second.state != State::waiting; });
  return still->second.state == State::yielded || begun < rendering_at_once;
}

std::optional<StreamId> StillQueue::first_ready() const {
  const auto found = std::ranges::find_if(stills_, [this](const auto& each) { return ready(each.first); });
  return found == stills_.end() ? std::nullopt : std::optional(found->first);
}

const Work& StillQueue::take(StreamId id) {
  Still& still = stills_.at(id);
  still.state = State::rendering;
  return still.work;
}

bool StillQueue::yield(StreamId id) {
  const auto still = stills_.find(id);
  if (still == stills_.end()) return false;
  still->second.state = State::yielded;
  return true;
}

}  // namespace cloudscape::stream
