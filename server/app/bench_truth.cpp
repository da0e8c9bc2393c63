// `cloudscape bench truth`: the light models against the path-traced reference.
#include <cstdio>
#include <filesystem>

#include "app/bench.h"
#include "app/frame_progress.h"
#include "app/gpu_stack.h"
#include "app/temporary_folder.h"
#include "bench/truth_report.h"
#include "bench/truth_run.h"
#include "core/error.h"
#include "core/log.h"
#include "settings/text_file.h"

namespace cloudscape::app {
namespace {

namespace fs = std::filesystem;

struct TruthOptions {
  GpuOptions gpu;
  std::string views = "all", models = "all", size = "256x144", cost_size = "640x360", quality = "high";
  std::string references, output;
  int samples = 256, model_samples = 0, cost_frames = 7;
};

Quality quality_of(const std::string& text) {
  const auto& names = EnumNames<Quality>::names;
  const auto found = std::find(names.begin(), names.end(), text);
  return static_cast<Quality>(found - names.begin());  // CLI11 has checked it
}

std::vector<std::string> marched_qualities() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < EnumNames<Quality>::names.size(); ++i)
    if (render_quality(static_cast<Quality>(i)).technique == Technique::march)
      names.emplace_back(EnumNames<Quality>::names[i]);
  return names;
}

fs::path references_folder(const TruthOptions& options) {
  if (!options.references.empty()) return options.references;
  const fs::path cache = cache_folder(options.gpu.cache_dir);
  if (cache.empty()) throw InvalidInput("--references", "is missing, and there is no cache folder: name a folder");
  return cache / "truth";
}

Frame render(GpuStack& stack, const FrameRequest& request) {
  auto job = stack.renderer.begin(request);
  SampleProgress progress;
  while (!stack.renderer.advance(*job))
    if (job->trace) progress.show(render::share_done(*job->trace), render::mean_samples(*job->trace));
  progress.end();
  return stack.renderer.collect(stack.renderer.finish(std::move(job)));
}

bench::TruthRun run_of(const TruthOptions& options) {
  bench::TruthRun run;
  run.views = bench::truth_views_of(options.views, settings::CloudscapeLibrary({}));
  run.models = bench::truth_models_of(options.models);
  run.size_px = size_of(options.size);
  run.cost_size_px = size_of(options.cost_size);
  run.reference_samples = options.samples;
  run.quality = quality_of(options.quality);
  run.model_samples = options.model_samples ? options.model_samples : render_quality(run.quality).samples;
  run.cost_frames = options.cost_frames;
  const fs::path references = references_folder(options);
  make_folder(references, "--references");
  run.references = bench::KeptReferences(references);
  run.pictures = options.output;
  run.tell = [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); };
  return run;
}

int run_truth(const TruthOptions& options) {
  log::start(options.gpu.log_level);
  bench::TruthRun run = run_of(options);
  const fs::path output = options.output;
  if (!output.empty()) make_folder(output, "--output");
  // What a new sun costs is to solve its light, not to read it: nothing may be kept of earlier runs.
  const TemporaryFolder empty_cache;
  GpuOptions gpu = options.gpu;
  if (run.cost_frames > 0) gpu.cache_dir = empty_cache.path();
  GpuStack stack(gpu, progress_on_stderr());
  run.render = [&](const FrameRequest& request) { return render(stack, request); };
  run.draw = [&](const FrameRequest& request) { return bench::timed_frame(stack.renderer, request); };
  const bench::TruthResults results = bench::run_truth(run);
  const bench::Machine machine = machine_of(stack.context);
  std::printf("%s, %s passes, %u cores\n%s", machine.renderer.c_str(), machine.execution.c_str(), machine.cores,
              bench::truth_tables(results).c_str());
  if (output.empty()) return 0;
  settings::write_text_file(output / "report.json", bench::truth_json(results, machine));
  settings::write_text_file(output / "index.html", bench::truth_html(results, machine));
  return 0;
}

}  // namespace

void add_bench_truth(CLI::App& bench, Run& run) {
  auto options = std::make_shared<TruthOptions>();
  CLI::App* command = bench.add_subcommand(
      "truth", "Compare the light models with the path-traced reference, and measure what each costs");
  command->add_option("--views", options->views, "all, or names of config/truth, with commas")->capture_default_str();
  command->add_option("--models", options->models, "all, or names of light models, with commas")->capture_default_str();
  command->add_option("--size", options->size, "WIDTHxHEIGHT of the pictures, pixels")->capture_default_str();
  command->add_option("--samples", options->samples, "Paths of each pixel of the reference")
      ->capture_default_str()
      ->check(CLI::Range(2, 65536));
  command->add_option("--references", options->references,
                      "Folder where references are kept from run to run (default: truth in the cache folder)");
  command->add_option("--quality", options->quality, "Quality of the models' pictures")
      ->capture_default_str()
      ->check(CLI::IsMember(marched_qualities()));
  command->add_option("--model-samples", options->model_samples, "Samples of the models' pictures [the quality's]")
      ->check(CLI::Range(1, 4096));
  command->add_option("--cost-size", options->cost_size, "WIDTHxHEIGHT of the frames that are timed, pixels")
      ->capture_default_str();
  command
      ->add_option("--cost-frames", options->cost_frames,
                   "Resting frames that are timed, with an empty cache; 0: costs are not measured")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000));
  command->add_option("-o,--output", options->output, "Folder for report.json, index.html and the pictures");
  add_gpu_options(*command, options->gpu);
  command->callback([options, &run] { run = [options] { return run_truth(*options); }; });
}

}  // namespace cloudscape::app
