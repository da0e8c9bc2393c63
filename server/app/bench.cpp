// `cloudscape bench`: what this machine can do.
#include "app/bench.h"

#include <unistd.h>

#include <cstdio>
#include <thread>

#include "core/error.h"

namespace cloudscape::app {

ImageSize size_of(const std::string& text, const std::string& option) {
  ImageSize size;
  char end = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &end) != 2 || size.width < 1 || size.height < 1 ||
      size.width > 8192 || size.height > 8192)
    throw InvalidInput(option, "is '" + text + "': must be WIDTHxHEIGHT, each within 1 and 8192");
  return size;
}

void make_folder(const std::filesystem::path& folder, const std::string& option) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw InvalidInput(option, "needs the folder '" + folder.string() + "', which cannot be made (" + error.message() +
                                   "): choose another place");
}

std::function<void(double)> share_progress(const std::string& doing) {
  const bool terminal = isatty(STDERR_FILENO) != 0;
  return [doing, terminal, last = -1](double share) mutable {
    const int percent = static_cast<int>(100 * share);
    if (terminal ? percent == last : percent / 10 == last / 10 && last >= 0) return;
    last = percent;
    std::fprintf(stderr, "%s%s: %d %%%s", terminal ? "\r" : "", doing.c_str(), percent,
                 percent == 100 || !terminal ? "\n" : "");
    std::fflush(stderr);
  };
}

bench::Machine machine_of(const gpu::Context& context) {
  const bool compute = context.execution() == gpu::PassExecution::compute;
  return {context.device().renderer, context.device().gl_version, compute ? "compute" : "fragment",
          std::thread::hardware_concurrency()};
}

void add_bench(CLI::App& program, Run& run) {
  CLI::App* bench = program.add_subcommand("bench", "Measure this machine");
  bench->require_subcommand(1);
  add_bench_frames(*bench, run);
  add_bench_track(*bench, run);
  add_bench_truth(*bench, run);
  add_bench_realtime(*bench, run);
  add_bench_streams(*bench, run);
}

}  // namespace cloudscape::app
