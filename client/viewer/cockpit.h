// The flight in a window.
#pragma once
#include "viewer/options.h"

namespace cloudscape::viewer {

// Returns when the person quits. Throws Error: no display, or the server refuses or never answered.
void fly_in_window(const Options& options);

}  // namespace cloudscape::viewer
