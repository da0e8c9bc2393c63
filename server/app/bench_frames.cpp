// `cloudscape bench frames`: what frames cost on this machine.
#include <cstdio>

#include "app/bench.h"
#include "app/bench_flight.h"
#include "app/gpu_stack.h"
#include "bench/frame_times.h"
#include "core/log.h"
#include "settings/cloudscape_json.h"
#include "settings/text_file.h"
#include "stream/moving_frame.h"

namespace cloudscape::app {
namespace {

struct BenchOptions {
  GpuOptions gpu;
  std::vector<std::string> cloudscapes{"fair-weather-cumulus", "stratocumulus-deck"};
  std::string size = "640x360", output;
  int frames = 10;
};

struct Variant {
  const char* name;
  Quality quality;
  int march_divisor;
};
constexpr Variant variants[] = {{"interactive", Quality::interactive, 1},
                                {"interactive", Quality::interactive, 2},
                                {"interactive", Quality::interactive, 4},
                                {"standard", Quality::standard, 1}};

FrameRequest request_of(const std::shared_ptr<const Cloudscape>& cloudscape, ImageSize size, const Variant& variant) {
  FrameRequest request = stream::request_of(view_of(cloudscape, size), 0, 0);
  request.quality = render_quality(variant.quality);
  request.quality.samples = 1;
  request.quality.march_divisor = variant.march_divisor;
  return request;
}

int run_bench(const BenchOptions& options) {
  log::start(options.gpu.log_level);
  const ImageSize size = size_of(options.size);
  const settings::CloudscapeLibrary library{{}};
  GpuOptions gpu = options.gpu;
  for (const std::string& name : options.cloudscapes) look_beside(gpu, name);
  GpuStack stack(gpu, progress_on_stderr());
  std::vector<bench::FrameTimes> rows;
  for (const std::string& name : options.cloudscapes) {
    const auto cloudscape = settings::find_cloudscape(library, name);
    for (const Variant& variant : variants) {
      rows.push_back(bench::measure_frames(stack.renderer, request_of(cloudscape, size, variant), options.frames));
      rows.back().cloudscape = name, rows.back().quality = variant.name;
    }
  }
  const bool compute = stack.context.execution() == gpu::PassExecution::compute;
  std::printf("%s, %s passes\n%s", stack.context.device().renderer.c_str(), compute ? "compute" : "fragment",
              bench::table_of(rows).c_str());
  if (!options.output.empty())
    settings::write_text_file(options.output,
                              bench::json_of(rows, stack.context.device().renderer, compute ? "compute" : "fragment"));
  return 0;
}

}  // namespace

void add_bench_frames(CLI::App& bench, Run& run) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = bench.add_subcommand("frames", "Time single frames of moving and resting quality");
  command->add_option("--cloudscape", options->cloudscapes, "Names or paths")->capture_default_str();
  command->add_option("--size", options->size, "WIDTHxHEIGHT, pixels")->capture_default_str();
  command->add_option("--frames", options->frames, "Frames of each variant")
      ->capture_default_str()
      ->check(CLI::Range(1, 10000));
  command->add_option("-o,--output", options->output, "JSON file to write");
  add_gpu_options(*command, options->gpu);
  command->callback([options, &run] { run = [options] { return run_bench(*options); }; });
}

}  // namespace cloudscape::app
