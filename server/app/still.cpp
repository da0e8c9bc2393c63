// `cloudscape still`: one picture into a file, or, along a path, one a frame (sequence.cpp).
#include <algorithm>

#include "app/commands.h"
#include "app/frame_progress.h"
#include "app/still_options.h"
#include "core/error.h"
#include "core/log.h"
#include "encode/encode.h"
#include "settings/named_documents.h"
#include "settings/still_request.h"
#include "settings/text_file.h"

namespace cloudscape::app {
namespace {

// The command line trusts its user further than the server trusts a stranger.
constexpr settings::StillLimits limits{
    .max_side_px = 16384, .max_megapixels = 134.3, .max_gigasteps = 1e9, .max_bake_mib = 1e6};

std::string flag_of(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return "--" + name;
}

std::string format_of(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension();
  if (extension == ".jpg" || extension == ".jpeg") return "jpeg";
  if (extension == ".png") return "png";
  if (extension == ".exr") return "exr";
  throw InvalidInput("--output", "is '" + path + "': its name must end in .jpg, .png or .exr");
}

// The library's name of the cloudscape that was named or whose document was; "" where none was.
std::string named_in(settings::CloudscapeLibrary& library, const std::string& name_or_file) {
  if (!settings::is_file_path(name_or_file)) return name_or_file;
  settings::find_cloudscape(library, name_or_file);  // its errors name the file
  library.put("file", settings::read_text_file(name_or_file, 256 * 1024));
  return "file";
}

Frame render(GpuStack& stack, const FrameRequest& request) {
  SampleProgress progress;
  auto job = stack.renderer.begin(request);
  while (!stack.renderer.advance(*job))
    if (job->trace) progress.show(render::share_done(*job->trace), render::mean_samples(*job->trace));
  progress.end();
  return stack.renderer.collect(stack.renderer.finish(std::move(job)));
}

int run_still(StillOptions options) {
  log::start(options.gpu.log_level);
  look_beside(options.gpu, options.cloudscape.empty() ? options.config : options.cloudscape);
  if (!options.path.empty()) return run_sequence(options);
  if (!options.frames.empty() || options.resume)
    throw InvalidInput(options.resume ? "--resume" : "--frames", "is for sequences: name a --path too");
  const settings::StillRequest request = still_request(options);
  settings::check_writable(options.output);
  GpuStack stack(options.gpu, progress_on_stderr());
  const Frame frame = render(stack, request.frame);
  settings::write_whole_file(options.output, encode::encode(frame, request.encoding).bytes);
  log::info("{}: {} samples, {:.0f} ms", options.output, frame.samples, frame.timings.render_ms);
  return 0;
}

void add_sequence_options(CLI::App& command, StillOptions& options) {
  command.add_option("--path", options.path,
                     "Camera path to render a sequence along: a name of config/paths, or a file; it gives pose, field "
                     "of view and time");
  command.add_option("--frames", options.frames,
                     "FIRST-LAST frame of the sequence; frame n is the path at n / frames-per-second [the whole path]");
  command.add_option("--frames-per-second", options.frames_per_second, "Frames for a second of the path's time")
      ->capture_default_str()
      ->check(CLI::Range(0.001, 1000.0));
  command.add_flag("--resume", options.resume, "Keep the frames whose files are there and whole");
}

}  // namespace

settings::StillRequest still_request(const StillOptions& options) {
  settings::CloudscapeLibrary library{{}};
  const std::string name = named_in(library, options.cloudscape);
  settings::Parameters parameters{{"format", format_of(options.output)}};
  if (!name.empty()) parameters.emplace_back("cloudscape", name);
  parameters.insert(parameters.end(), options.parameters.begin(), options.parameters.end());
  if (!options.config.empty())
    return settings::still_from_document(settings::find_still(options.config), parameters, library, limits);
  if (name.empty()) throw InvalidInput("cloudscape", "is missing: name one, or a still with --config");
  return settings::still_from_parameters(parameters, library, limits);
}

void add_still(CLI::App& program, Run& run) {
  auto options = std::make_shared<StillOptions>();
  CLI::App* command = program.add_subcommand("still", "Render one picture, or a sequence, into files");
  command->add_option("cloudscape", options->cloudscape,
                      "Name of a cloudscape, or a document's path; needed without --config");
  command->add_option(
      "--config", options->config,
      "Still to render: a name of `cloudscape list --stills`, or a file as POST /api/v1/stills takes it; "
      "options beside it go first");
  command
      ->add_option("-o,--output", options->output,
                   "File to write: .jpg, .png or .exr; with --path one a frame, # for its digits: frame_####.png")
      ->required();
  for (const settings::ParameterInfo& parameter : settings::still_parameters(limits)) {
    if (parameter.name == "cloudscape" || parameter.name == "still" || parameter.name == "format") continue;
    const std::string about = parameter.description + " [" + parameter.default_text + "]";
    command->add_option_function<std::string>(
        flag_of(parameter.name),
        [options, name = parameter.name](const std::string& value) { options->parameters[name] = value; }, about);
  }
  add_sequence_options(*command, *options);
  add_gpu_options(*command, options->gpu);
  command->callback([options, &run] { run = [options] { return run_still(*options); }; });
}

}  // namespace cloudscape::app
