// `cloudscape bench streams`: how many viewers this machine carries.
#include <cstdio>

#include "app/bench.h"
#include "app/bench_flight.h"
#include "bench/stream_counts.h"
#include "core/log.h"
#include "settings/cloudscape_json.h"
#include "settings/text_file.h"

namespace cloudscape::app {
namespace {

namespace fs = std::filesystem;

struct StreamsOptions {
  GpuOptions gpu;
  std::string cloudscape = "thesis", path = "test-track", size = "1280x720", output;
  FlightPlan plan{.viewers = {.path = {}, .speed = 0.6}};
  int streams = 0, most = 256;
};

// Evenly over the path, there and back, so that no two see the same.
std::vector<SimulatedViewers::Viewer> viewers_of(const stream::StreamView& view, const settings::CameraPath& path,
                                                 int streams) {
  std::vector<SimulatedViewers::Viewer> viewers;
  for (int i = 0; i < streams; ++i)
    viewers.push_back({view, path.keys.front().time_s + 2 * length_s(path) * i / streams});
  return viewers;
}

bench::StreamsFigures measure(GpuStack& stack, const FlightPlan& plan, const stream::StreamView& view, int streams) {
  std::fprintf(stderr, "%d streams\n", streams);
  const Flown flown = fly(stack, plan, viewers_of(view, plan.viewers.path, streams));
  bench::StreamsFigures figures = bench::streams_figures(flown.frames, flown.seconds);
  std::size_t frames = 0;
  for (const auto& stream : flown.frames) frames += stream.size();
  figures.cpu_ms = frames > 0 ? flown.cpu_ms / static_cast<double>(frames) : 0;
  figures.busy_share = flown.busy_share;
  figures.stream_bytes = static_cast<double>(flown.history_bytes) / streams;
  figures.sky_bakes = static_cast<int>(flown.sky_bakes / flown.seconds);
  return figures;
}

bench::StreamsResults given(const bench::StreamsFigures& figures) {
  bench::StreamsResults results;
  results.measured[figures.streams] = figures;
  for (const double fps : bench::asked_fps)
    results.held[static_cast<int>(fps)] = bench::holds(figures, fps) ? figures.streams : 0;
  return results;
}

int run_streams(const StreamsOptions& options) {
  log::start(options.gpu.log_level);
  const stream::StreamView view =
      view_of(settings::find_cloudscape(settings::CloudscapeLibrary({}), options.cloudscape), size_of(options.size));
  FlightPlan plan = options.plan;
  plan.viewers.path = settings::find_camera_path(options.path);
  const fs::path output = options.output;
  if (output.has_parent_path()) make_folder(output.parent_path(), "--output");
  GpuOptions gpu = options.gpu;
  look_beside(gpu, options.cloudscape);
  GpuStack stack(gpu, progress_on_stderr());
  const auto measured = [&](int streams) { return measure(stack, plan, view, streams); };
  const bench::StreamsResults results =
      options.streams > 0 ? given(measured(options.streams)) : bench::find_streams(options.most, measured);
  const bench::StreamsSubject subject{options.cloudscape, options.path, view.size_px,
                                      options.streams > 0 ? 0 : options.most};
  const bench::Machine machine = machine_of(stack.context);
  std::printf("%s, %s passes, %u cores\n%s", machine.renderer.c_str(), machine.execution.c_str(), machine.cores,
              bench::streams_table(results, subject).c_str());
  if (!output.empty()) settings::write_text_file(output, bench::streams_json(results, subject, machine));
  return 0;
}

}  // namespace

void add_bench_streams(CLI::App& bench, Run& run) {
  auto options = std::make_shared<StreamsOptions>();
  CLI::App* command = bench.add_subcommand(
      "streams", "Find how many streams hold 30 and 60 frames a second, all flying one path of one document");
  command->add_option("--cloudscape", options->cloudscape, "Name or path")->capture_default_str();
  command->add_option("--path", options->path, "Camera path: name or path")->capture_default_str();
  command->add_option("--size", options->size, "WIDTHxHEIGHT of each stream, pixels")->capture_default_str();
  command->add_option("--streams", options->streams, "Measure so many and no others [search]")
      ->check(CLI::Range(1, 1024));
  command->add_option("--most", options->most, "What the search may ask for")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  command->add_option("--seconds", options->plan.seconds, "Measured flight of each number of streams, s")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 86400.0));
  add_flight_options(*command, options->plan);
  command->add_option("-o,--output", options->output, "JSON file to write");
  add_gpu_options(*command, options->gpu);
  command->callback([options, &run] { run = [options] { return run_streams(*options); }; });
}

}  // namespace cloudscape::app
