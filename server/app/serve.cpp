// `cloudscape serve`: threads, and the order in which they start and stop.
#include <pthread.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "app/commands.h"
#include "app/embedded_page.h"
#include "app/encode_pool.h"
#include "app/render_loop.h"
#include "core/log.h"
#include "encode/containers.h"
#include "net/server.h"
#include "settings/server_settings.h"

extern char** environ;

namespace cloudscape::app {
namespace {

constexpr const char* first_cloudscape = "fair-weather-cumulus";  // what the page opens with

struct ServeOptions {
  std::string config;
  settings::TextMap flags;
};

settings::TextMap environment() {
  settings::TextMap variables;
  for (char** entry = environ; *entry; ++entry) {
    const std::string text = *entry;
    const std::size_t equals = text.find('=');
    if (equals != std::string::npos) variables[text.substr(0, equals)] = text.substr(equals + 1);
  }
  return variables;
}

settings::ServerSettings settings_of(const ServeOptions& options) {
  std::optional<std::filesystem::path> file;
  const char* config = std::getenv("CLOUDSCAPE_CONFIG");
  if (!options.config.empty())
    file = options.config;
  else if (config && *config)
    file = config;
  return settings::load_server_settings(file, environment(), options.flags);
}

GpuOptions gpu_options(const settings::ServerSettings& settings) {
  return {settings.egl_device, settings.require_gpu,    settings.pass_execution,
          settings.shader_dir, settings.cache_dir,      settings.cache_limit_mib,
          settings.log_level,  settings.height_map_dir, settings.volume_dir};
}

sigset_t stop_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

// Waits for SIGINT or SIGTERM on a thread of its own, so that stopping is ordinary code. The signals must be blocked in
// every thread; SIGTERM to itself ends it.
class StopOnSignal {
 public:
  explicit StopOnSignal(net::Server& server)
      : thread_([&server] {
          const sigset_t signals = stop_signals();
          int signal = 0;
          sigwait(&signals, &signal);
          server.request_stop();
        }) {}
  ~StopOnSignal() {
    pthread_kill(thread_.native_handle(), SIGTERM);
    thread_.join();
  }

 private:
  std::thread thread_;
};

// Start: listen, render thread, ready, serve. Stop: the network drains while frames are still rendered, then the
// scheduler lets the render thread go, then the encoders finish, then the sockets' memory is freed.
int run_serve(const ServeOptions& options) {
  const settings::ServerSettings settings = settings_of(options);
  log::start(settings.log_level);
  const sigset_t signals = stop_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  Metrics metrics;
  settings::CloudscapeLibrary library(settings.cloudscapes_dir);
  stream::FrameScheduler scheduler(
      {.target_frame_ms = settings.target_frame_ms, .still_queue = static_cast<std::size_t>(settings.still_queue)},
      metrics);
  EncodePool disk(1, "disk");
  net::Server server({settings,
                      scheduler,
                      library,
                      metrics,
                      embedded_page,
                      {[&disk](auto task) { disk.run(std::move(task)); }, encode::open_container},
                      embedded_pictures});
  const auto on_ready = [&server] {
    std::printf("ready: %s\n", server.ready_link().c_str());
    std::fflush(stdout);
  };
  std::exception_ptr failure;
  {
    const StopOnSignal stop(server);
    RenderLoop renderer(gpu_options(settings), library.get(first_cloudscape), scheduler, server, metrics, on_ready);
    server.run();
    scheduler.stop();
    failure = renderer.failure();
  }
  if (failure) std::rethrow_exception(failure);
  return 0;
}

void add_setting(CLI::App& command, const std::shared_ptr<ServeOptions>& options,
                 const settings::ParameterInfo& setting) {
  const std::string about = setting.description + " [" + setting.default_text + "]";
  const std::string flag = settings::flag_name(setting.name);
  if (setting.type == "boolean") {
    command.add_flag_callback(
        flag, [options, name = setting.name] { options->flags[name] = "true"; }, about);
    return;
  }
  command.add_option_function<std::string>(
      flag, [options, name = setting.name](const std::string& value) { options->flags[name] = value; }, about);
}

}  // namespace

void add_serve(CLI::App& program, Run& run) {
  auto options = std::make_shared<ServeOptions>();
  CLI::App* command = program.add_subcommand("serve", "Serve the page, the streams and the stills");
  command->add_option("--config", options->config, "JSON file of settings; config/server.json lists them all");
  for (const settings::ParameterInfo& setting : settings::server_parameters()) add_setting(*command, options, setting);
  command->footer(
      "A flag goes before the environment (CLOUDSCAPE_MAX_STREAMS for --max-streams), that before the file.");
  command->callback([options, &run] { run = [options] { return run_serve(*options); }; });
}

}  // namespace cloudscape::app
