// The subcommands of `cloudscape bench`.
#pragma once
#include <filesystem>
#include <string>

#include "app/commands.h"
#include "bench/track_report.h"
#include "core/frame.h"
#include "gpu/context.h"

namespace cloudscape::app {

void add_bench_frames(CLI::App& bench, Run& run);
void add_bench_track(CLI::App& bench, Run& run);
void add_bench_truth(CLI::App& bench, Run& run);

// "640x360". Throws InvalidInput.
ImageSize size_of(const std::string& text);
// Made before a long run, so that it does not end without a place for what it found. Throws InvalidInput.
void make_folder(const std::filesystem::path& folder, const std::string& option);
bench::Machine machine_of(const gpu::Context& context);

}  // namespace cloudscape::app
