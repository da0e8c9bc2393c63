// What a bake costs in each format of the volume, measured.
#pragma once
#include "app/gpu_stack.h"
#include "core/cloudscape.h"

namespace cloudscape::app {

// Bakes the cloudscape in its own format (kept in the cache) and in the other one (not kept), and prints a table on
// stdout: texels, bytes on the device and on disk, time of the bake and of loading it from disk.
void print_bake_costs(GpuStack& stack, const GpuOptions& options, const Cloudscape& cloudscape);

}  // namespace cloudscape::app
