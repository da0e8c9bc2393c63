// What `cloudscape still` was asked for, shared by one picture and by sequences.
#pragma once
#include <map>
#include <string>

#include "app/gpu_stack.h"
#include "settings/still_request.h"

namespace cloudscape::app {

struct StillOptions {
  GpuOptions gpu;
  std::string cloudscape, config, output;
  std::map<std::string, std::string> parameters;  // of the still, by their names in a query
  std::string path, frames;                       // of a sequence
  double frames_per_second = 30;
  bool resume = false;
};

settings::StillRequest still_request(const StillOptions& options);  // throws InvalidInput, NotFound, Error

// `cloudscape still --path`: frames along a camera path, a file each. Returns the exit code: 0, or 128 + the number of
// the signal that stopped it. Throws Error.
int run_sequence(const StillOptions& options);

}  // namespace cloudscape::app
