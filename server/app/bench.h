// The subcommands of `cloudscape bench`.
#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "app/commands.h"
#include "bench/track_report.h"
#include "core/frame.h"
#include "gpu/context.h"

namespace cloudscape::app {

void add_bench_frames(CLI::App& bench, Run& run);
void add_bench_track(CLI::App& bench, Run& run);
void add_bench_truth(CLI::App& bench, Run& run);
void add_bench_realtime(CLI::App& bench, Run& run);
void add_bench_streams(CLI::App& bench, Run& run);

struct FlightPlan;
// --speed, --target-fps, --poses, --latency-ms, --warm-up
void add_flight_options(CLI::App& command, FlightPlan& plan);

// "640x360". Throws InvalidInput.
ImageSize size_of(const std::string& text, const std::string& option = "--size");
// Made before a long run, so that it does not end without a place for what it found. Throws InvalidInput.
void make_folder(const std::filesystem::path& folder, const std::string& option);
// Says on stderr how much is done: one line, or ten where nobody watches.
std::function<void(double)> share_progress(const std::string& doing);
bench::Machine machine_of(const gpu::Context& context);

}  // namespace cloudscape::app
