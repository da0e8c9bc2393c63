#include "core/beside_frames.h"

#include <sys/resource.h>
#include <unistd.h>

namespace cloudscape {

// tuned: a tenth of what a thread of frames gets where both want a processor, and all that nobody wants. Linux has it
// by thread.
void yield_to_frames() { setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), 10); }

}  // namespace cloudscape
