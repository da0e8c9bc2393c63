// The subcommands of `cloudscape bench`.
#pragma once
#include <string>

#include "app/commands.h"
#include "core/frame.h"

namespace cloudscape::app {

void add_bench_frames(CLI::App& bench, Run& run);
void add_bench_track(CLI::App& bench, Run& run);

// "640x360". Throws InvalidInput.
ImageSize size_of(const std::string& text);

}  // namespace cloudscape::app
