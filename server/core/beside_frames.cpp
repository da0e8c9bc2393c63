#include "core/beside_frames.h"

#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>

namespace cloudscape {
namespace {

// Of sched_setattr(2), which the C library does not wrap.
struct SchedulingAttributes {
  std::uint32_t size, policy;
  std::uint64_t flags;
  std::int32_t nice;
  std::uint32_t priority;
  std::uint64_t runtime_ns, deadline_ns, period_ns;
};

// tuned: a tenth of what a thread of frames gets where both want a processor, and all that nobody wants; a thirtieth
// makes frames a tenth quicker, and what they wait for three times as late.
constexpr std::int32_t nice_if_awaited = 10, nice_if_lagging = 15;
// The shortest turn that there is (Linux 6.12 and later; others ignore it): so long a thread of frames that wakes
// waits.
constexpr std::uint64_t turn_ns = 100'000;

}  // namespace

// Linux has both by thread. A program that was started with less keeps that; a container may forbid the one call.
void yield_to_frames(Beside beside) {
  if (!MovingPicture::anywhere()) return;
  const auto thread = static_cast<id_t>(gettid());
  const std::int32_t wanted = beside == Beside::awaited ? nice_if_awaited : nice_if_lagging;
  const std::int32_t nice = std::max(wanted, getpriority(PRIO_PROCESS, thread));
  const SchedulingAttributes attributes{sizeof attributes, SCHED_OTHER, 0, nice, 0, turn_ns, 0, 0};
  if (syscall(SYS_sched_setattr, 0, &attributes, 0) != 0) setpriority(PRIO_PROCESS, thread, nice);
}

}  // namespace cloudscape
