#include "app/gpu_stack.h"

#include <malloc.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <memory>

#include "core/log.h"

namespace cloudscape::app {
namespace {

constexpr double bytes_per_mib = 1024.0 * 1024.0;
constexpr std::uint64_t device_bake_bytes = std::uint64_t{1} << 30;  // tuned: a dozen bakes of 128^3 and one of 512^3

// Frames of some MiB come and go many times a second: glibc would ask the kernel for each one's pages anew.
void keep_memory_of_frames() {
  constexpr int keep_below = 64 << 20, trim_above = 512 << 20;  // bytes; tuned: a frame of 4K is 33 MiB
  mallopt(M_MMAP_THRESHOLD, keep_below);
  mallopt(M_TRIM_THRESHOLD, trim_above);
}

gpu::ContextOptions context_options(const GpuOptions& options) {
  return {options.egl_device, options.require_gpu, gpu::pass_execution_from(options.pass_execution)};
}

}  // namespace

std::uint64_t bytes_of_mib(double mib) { return static_cast<std::uint64_t>(mib * bytes_per_mib); }

void add_gpu_options(CLI::App& command, GpuOptions& options) {
  command
      .add_option("--egl-device", options.egl_device,
                  "auto, software, an index of `cloudscape devices`, or /dev/dri/...")
      ->capture_default_str();
  command.add_flag("--require-gpu", options.require_gpu, "Refuse to run on a software renderer");
  command.add_option("--pass-execution", options.pass_execution, "auto, compute or fragment")->capture_default_str();
  command.add_option("--shader-dir", options.shader_dir, "Read shaders from this folder instead of the program");
  command.add_option("--cache-dir", options.cache_dir, "Folder of baked textures (default: the user's cache folder)");
  command.add_option("--cache-limit-mib", options.cache_limit_mib, "What baked textures may take on disk, MiB")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  command.add_option("--height-map-dir", options.height_map_dir,
                     "Folder of the height maps that a terrain may name (default: the document's)");
  command.add_option("--volume-dir", options.volume_dir,
                     "Folder of the volumes (.vdb, .raw, .exr) that a document may name (default: the document's)");
  command.add_option("--log-level", options.log_level, "debug, info, warn, error or off")->capture_default_str();
}

void look_beside(GpuOptions& options, const std::string& cloudscape) {
  if (!cloudscape.ends_with(".json")) return;
  const std::filesystem::path parent = std::filesystem::path(cloudscape).parent_path();
  const std::string beside = parent.empty() ? "." : parent.string();
  for (std::string* folder : {&options.height_map_dir, &options.volume_dir})
    if (folder->empty()) *folder = beside;
}

std::filesystem::path cache_folder(const std::string& cache_dir) {
  if (!cache_dir.empty()) return cache_dir;
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache)
    return std::filesystem::path(cache) / "cloudscape";
  if (const char* home = std::getenv("HOME"); home && *home)
    return std::filesystem::path(home) / ".cache" / "cloudscape";
  return {};
}

GpuStack::GpuStack(const GpuOptions& options, bake::BakeStore::Progress progress)
    : context(context_options(options)),
      shaders(options.shader_dir),
      bakes(context, shaders, bake::BakeCache(cache_folder(options.cache_dir), bytes_of_mib(options.cache_limit_mib)),
            device_bake_bytes, std::move(progress), options.volume_dir),
      renderer(context, shaders, bakes, options.height_map_dir) {
  keep_memory_of_frames();
}

bake::BakeStore::Progress progress_on_stderr() {
  const bool terminal = isatty(STDERR_FILENO) != 0;
  return [terminal, last = -1](const bake::BakeRecipe& recipe, double share) mutable {
    const int percent = static_cast<int>(100 * share);
    if (percent == last || recipe.resolution == 1 || (!terminal && percent != 100)) return;
    last = percent;
    std::fprintf(stderr, "%sbaking %d^3 texels: %d %%%s", terminal ? "\r" : "", recipe.resolution, percent,
                 percent == 100 ? "\n" : "");
    std::fflush(stderr);
  };
}

}  // namespace cloudscape::app
