// `cloudscape bench track`: the thesis' test track (Olajos 3.1, 3.2).
#include <cstdio>
#include <filesystem>

#include "app/bench.h"
#include "app/gpu_stack.h"
#include "bench/track_report.h"
#include "core/log.h"
#include "settings/cloudscape_json.h"
#include "settings/text_file.h"

namespace cloudscape::app {
namespace {

namespace fs = std::filesystem;

struct TrackOptions {
  GpuOptions gpu;
  std::string cloudscape = "thesis", path = "test-track", size = "1280x720", variants = "all";
  std::string output, plots;
  int frames = 200;
};

// Where the results go; empty: nowhere.
struct Results {
  fs::path json, plots;
};

// Makes the folders, so that a long run does not end without a place for what it found.
Results results_of(const TrackOptions& options) {
  Results results{options.output, options.plots};
  if (!options.output.empty() && results.json.extension() != ".json") {
    if (results.plots.empty()) results.plots = results.json;
    results.json /= "track.json";
  }
  if (results.json.has_parent_path()) make_folder(results.json.parent_path(), "--output");
  if (!results.plots.empty()) make_folder(results.plots, "--plots");
  return results;
}

bench::TrackTimes measure(const TrackOptions& options, const Cloudscape& cloudscape, const settings::CameraPath& path,
                          ImageSize size, const std::vector<bench::TrackVariant>& variants, GpuStack& stack) {
  std::vector<FrameRequest> requests;
  for (const bench::TrackVariant variant : variants)
    requests.push_back(bench::track_request(cloudscape, size, variant));
  bench::TrackRun run;
  run.frames = options.frames;
  run.progress = share_progress("flying along the track");
  bench::TrackTimes track = bench::run_track(
      path, requests, run, [&](const FrameRequest& request) { return bench::timed_frame(stack.renderer, request); });
  for (std::size_t i = 0; i < variants.size(); ++i) track.variants[i].variant = variants[i];
  track.cloudscape = options.cloudscape, track.path = options.path;
  return track;
}

int run_track(const TrackOptions& options) {
  log::start(options.gpu.log_level);
  const ImageSize size = size_of(options.size);
  const auto variants = bench::variants_of(options.variants);
  const auto cloudscape = settings::find_cloudscape(settings::CloudscapeLibrary({}), options.cloudscape);
  const settings::CameraPath path = settings::find_camera_path(options.path);
  const Results results = results_of(options);
  GpuOptions gpu = options.gpu;
  look_beside(gpu, options.cloudscape);
  GpuStack stack(gpu, progress_on_stderr());
  const bench::Machine machine = machine_of(stack.context);
  const bench::TrackTimes track = measure(options, *cloudscape, path, size, variants, stack);
  std::printf("%s, %s passes, %u cores\n%s", machine.renderer.c_str(), machine.execution.c_str(), machine.cores,
              bench::track_tables(track).c_str());
  if (!results.json.empty()) settings::write_text_file(results.json, bench::track_json(track, machine));
  if (results.plots.empty()) return 0;
  for (const bench::Figure& figure : bench::track_figures(track))
    settings::write_text_file(results.plots / figure.file, bench::svg_of(figure.plot));
  return 0;
}

}  // namespace

void add_bench_track(CLI::App& bench, Run& run) {
  auto options = std::make_shared<TrackOptions>();
  CLI::App* command = bench.add_subcommand(
      "track", "Fly a camera path once for each technique of the thesis, switched on and off, and compare the times");
  command->add_option("--cloudscape", options->cloudscape, "Name or path")->capture_default_str();
  command->add_option("--path", options->path, "Camera path: name or path")->capture_default_str();
  command->add_option("--size", options->size, "WIDTHxHEIGHT, pixels")->capture_default_str();
  command->add_option("--frames", options->frames, "Frames of each variant, evenly along the path")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000));
  command
      ->add_option(
          "--variants", options->variants,
          "all, or some of structure-off, distance-field, adaptive-on, light-off, phase-mie, phase-none, with commas")
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "JSON file to write, or a folder for it and the plots");
  command->add_option("--plots", options->plots, "Folder for the plots (SVG)");
  add_gpu_options(*command, options->gpu);
  command->callback([options, &run] { run = [options] { return run_track(*options); }; });
}

}  // namespace cloudscape::app
