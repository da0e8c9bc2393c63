// Work beside the frames runs at a lower priority than they do.
#include "core/beside_frames.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <thread>

namespace cloudscape {
namespace {

int niceness() { return getpriority(PRIO_PROCESS, static_cast<id_t>(gettid())); }

TEST(BesideFrames, WorkYieldsAndSoDoesWhatItStarts) {
  const MovingPicture flown;
  const int own = niceness();
  auto seen = beside_frames([] { return std::pair(niceness(), std::async(std::launch::async, niceness).get()); });
  const auto [worker, started] = seen.get();
  EXPECT_GT(worker, own);
  EXPECT_EQ(started, worker);
  EXPECT_EQ(niceness(), own) << "who asked does not yield";
  EXPECT_GT(beside_frames(niceness, Beside::lagging).get(), worker) << "nobody waits for it";
}

// It waited for every other program of the machine: a still under the sanitizers took 14 s, and 133 s beside two of
// them.
TEST(BesideFrames, WorkDoesNotYieldWhereNobodyFlies) {
  const int own = niceness();
  EXPECT_EQ(beside_frames(niceness).get(), own);
  { const MovingPicture flown; }
  EXPECT_EQ(beside_frames(niceness, Beside::lagging).get(), own);
}

}  // namespace
}  // namespace cloudscape
