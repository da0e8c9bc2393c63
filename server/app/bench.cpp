// `cloudscape bench`: what this machine can do.
#include "app/bench.h"

#include <cstdio>
#include <thread>

#include "core/error.h"

namespace cloudscape::app {

ImageSize size_of(const std::string& text) {
  ImageSize size;
  char end = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &end) != 2 || size.width < 1 || size.height < 1 ||
      size.width > 8192 || size.height > 8192)
    throw InvalidInput("--size", "is '" + text + "': must be WIDTHxHEIGHT, each within 1 and 8192");
  return size;
}

void make_folder(const std::filesystem::path& folder, const std::string& option) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw InvalidInput(option, "needs the folder '" + folder.string() + "', which cannot be made (" + error.message() +
                                   "): choose another place");
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
}

}  // namespace cloudscape::app
