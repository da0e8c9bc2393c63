// A flight along a camera path without a window: saves the frames and a report.
#pragma once
#include "viewer/options.h"

namespace cloudscape::viewer {

// Throws Error: the path or the folder cannot be used, the server refuses, or sends nothing for too long.
void record_flight(const Options& options);

}  // namespace cloudscape::viewer
