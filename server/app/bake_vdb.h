// The final density of a cloudscape as an OpenVDB file.
#pragma once
#include <string>

#include "app/gpu_stack.h"
#include "core/cloudscape.h"

namespace cloudscape::app {

struct VdbOptions {
  std::string file;  // "": none
  int resolution = 256;
  std::string up = "z";
};

// Writes the file and prints on stdout what another program needs to know of it. Throws InvalidInput, Error.
void bake_vdb(GpuStack& stack, const Cloudscape& cloudscape, const VdbOptions& options);

}  // namespace cloudscape::app
