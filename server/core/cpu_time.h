// Time on the processors.
#pragma once

namespace cloudscape {

double process_cpu_ms();  // of all threads; those that have ended included

}  // namespace cloudscape
