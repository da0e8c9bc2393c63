// `cloudscape bench realtime`: what a person who flies is given, and how true it is.
#include <cstdio>

#include "app/bench.h"
#include "app/bench_flight.h"
#include "bench/realtime_report.h"
#include "core/log.h"
#include "settings/cloudscape_json.h"
#include "settings/text_file.h"
#include "stream/quality_control.h"

namespace cloudscape::app {
namespace {

namespace fs = std::filesystem;

struct RealtimeOptions {
  GpuOptions gpu;
  std::string cloudscape = "thesis", path = "test-track", size = "1280x720", flicker_size, output;
  FlightPlan plan{.viewers = {.path = {}, .speed = 0.6}, .seconds = 0};
  int detail = -1, legs = 8, truth_samples = 16, flicker_frames = 60;
  double flicker_at_s = -1;
};

// The middle of the path's last section: the test track's shows clouds from the side, as far as they go.
double flicker_place_s(const settings::CameraPath& path) {
  if (path.sections.empty()) return (path.keys.front().time_s + path.keys.back().time_s) / 2;
  return (path.sections.back().begin_s + path.sections.back().end_s) / 2;
}

bench::QualityRun quality_run(const RealtimeOptions& options, const stream::StreamView& view,
                              const settings::CameraPath& path, ImageSize flicker_size, int flown_detail,
                              GpuStack& stack) {
  bench::QualityRun run;
  run.view = view;
  run.path = path;
  run.speed = options.plan.viewers.speed;
  run.detail = options.detail >= 0 ? options.detail : flown_detail;
  run.legs = options.legs;
  run.truth_samples = options.truth_samples;
  run.flicker_frames = options.flicker_frames;
  run.flicker_at_s = options.flicker_at_s >= 0 ? options.flicker_at_s : flicker_place_s(path);
  run.flicker_size_px = flicker_size;
  run.draw = [&stack](const FrameRequest& request) { return stack.renderer.render(request); };
  run.forget = [&stack](StreamId stream) { stack.renderer.forget(stream); };
  run.progress = share_progress("judging the moving pictures");
  return run;
}

void take_figures(bench::RealtimeResults& results, const Flown& flown) {
  results.flight = bench::figures_of(flown.frames.front(), flown.seconds);
  if (results.flight.frames == 0) return;
  results.cpu_ms = flown.cpu_ms / results.flight.frames;
  for (const auto& [name, ms] : flown.threads) results.threads[name] = ms / results.flight.frames;
}

bench::RealtimeResults results_of(const RealtimeOptions& options, const FlightPlan& plan, ImageSize size) {
  bench::RealtimeResults results;
  results.cloudscape = options.cloudscape, results.path = options.path, results.size_px = size;
  results.speed = plan.viewers.speed;
  results.speed_m_per_s = mean_speed_m_per_s(plan.viewers.path, plan.viewers.speed);
  results.target_fps = plan.target_fps;
  results.poses_per_s = plan.viewers.poses_per_s, results.latency_ms = plan.viewers.latency_ms;
  return results;
}

int run_realtime(const RealtimeOptions& options) {
  log::start(options.gpu.log_level);
  const ImageSize size = size_of(options.size);
  const ImageSize flicker_size = options.flicker_size.empty() ? size : size_of(options.flicker_size, "--flicker-size");
  const auto cloudscape = settings::find_cloudscape(settings::CloudscapeLibrary({}), options.cloudscape);
  FlightPlan plan = options.plan;
  plan.viewers.path = settings::find_camera_path(options.path);
  if (plan.seconds <= 0) plan.seconds = length_s(plan.viewers.path) / plan.viewers.speed;
  const fs::path output = options.output;
  if (output.has_parent_path()) make_folder(output.parent_path(), "--output");
  GpuOptions gpu = options.gpu;
  look_beside(gpu, options.cloudscape);
  GpuStack stack(gpu, progress_on_stderr());
  const stream::StreamView view = view_of(cloudscape, size);
  bench::RealtimeResults results = results_of(options, plan, size);
  take_figures(results, fly(stack, plan, {{view, plan.viewers.path.keys.front().time_s}}));
  if (options.legs > 0 || options.flicker_frames > 0) {
    results.judged = quality_run(options, view, plan.viewers.path, flicker_size, results.flight.detail, stack);
    results.quality = bench::judge_moving(results.judged);
  }
  const bench::Machine machine = machine_of(stack.context);
  std::printf("%s, %s passes, %u cores\n%s", machine.renderer.c_str(), machine.execution.c_str(), machine.cores,
              bench::realtime_table(results).c_str());
  if (!output.empty()) settings::write_text_file(output, bench::realtime_json(results, machine));
  return 0;
}

void add_quality_options(CLI::App& command, RealtimeOptions& options) {
  command
      .add_option("--legs", options.legs,
                  "Seconds of flight, evenly over the path, of which every tenth frame is compared; 0: none")
      ->capture_default_str()
      ->check(CLI::Range(0, 10000));
  command
      .add_option("--truth-samples", options.truth_samples,
                  "Pictures that are averaged for what a moving frame is compared with")
      ->capture_default_str()
      ->check(CLI::Range(1, 4096));
  command
      .add_option("--detail", options.detail,
                  "Detail of the pictures that are compared, 0 (marched whole) to " +
                      std::to_string(stream::moving_details.size() - 1) + " [as most were flown]")
      ->check(CLI::Range(0, static_cast<int>(stream::moving_details.size()) - 1));
  command
      .add_option("--flicker-frames", options.flicker_frames,
                  "Frames of a still camera and of a slow pan that flicker is measured in; 0: it is not")
      ->capture_default_str()
      ->check(CLI::Range(0, 10000));
  command.add_option("--flicker-at", options.flicker_at_s, "Where on the path, s [the middle of its last section]")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--flicker-size", options.flicker_size, "WIDTHxHEIGHT of those frames, pixels [--size]");
}

}  // namespace

void add_flight_options(CLI::App& command, FlightPlan& plan) {
  command
      .add_option("--speed", plan.viewers.speed,
                  "Seconds of the path flown in a second; the test track at 0.6 is flown at 120 m/s, as the page flies")
      ->capture_default_str()
      ->check(CLI::Range(0.001, 1000.0));
  command.add_option("--target-fps", plan.target_fps, "What moving pictures aim at, frames a second")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 1000.0));
  command.add_option("--poses", plan.viewers.poses_per_s, "Poses that a viewer sends in a second")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 1000.0));
  command
      .add_option("--latency-ms", plan.viewers.latency_ms,
                  "From the encoder until the viewer's acknowledgement; 0: at once")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 10000.0));
  command
      .add_option("--sun-speed", plan.viewers.sun_deg_per_s,
                  "Degrees by which the sun is turned about the zenith in a second, with each pose")
      ->capture_default_str()
      ->check(CLI::Range(-3600.0, 3600.0));
  command
      .add_option("--sun-climb", plan.viewers.sun_climb_deg_per_s,
                  "Degrees by which the sun rises in a second, up to 60, and sets again, down to 5")
      ->capture_default_str()
      ->check(CLI::Range(-3600.0, 3600.0));
  command
      .add_option("--warm-up", plan.warm_up_s,
                  "Flight before the measurement, s; up to ten times as long until ten frames of each have arrived")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1000.0));
}

void add_bench_realtime(CLI::App& bench, Run& run) {
  auto options = std::make_shared<RealtimeOptions>();
  CLI::App* command = bench.add_subcommand(
      "realtime", "Fly a camera path as a person does, through the whole path of a stream, and judge what arrives");
  command->add_option("--cloudscape", options->cloudscape, "Name or path")->capture_default_str();
  command->add_option("--path", options->path, "Camera path: name or path")->capture_default_str();
  command->add_option("--size", options->size, "WIDTHxHEIGHT, pixels")->capture_default_str();
  command->add_option("--seconds", options->plan.seconds, "Measured flight, s [the whole path]")
      ->check(CLI::Range(0.1, 86400.0));
  command->add_option("--frames", options->plan.frames, "Ends the flight after so many frames")
      ->check(CLI::Range(1, 10000000));
  add_flight_options(*command, options->plan);
  add_quality_options(*command, *options);
  command->add_option("-o,--output", options->output, "JSON file to write");
  add_gpu_options(*command, options->gpu);
  command->callback([options, &run] { run = [options] { return run_realtime(*options); }; });
}

}  // namespace cloudscape::app
