// Everything that renders, in the order in which it is made: device, shaders, bakes, renderer. Lives on one thread.
#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "bake/store.h"
#include "gpu/context.h"
#include "gpu/shader_source.h"
#include "render/renderer.h"

namespace cloudscape::app {

struct GpuOptions {
  std::string egl_device = "auto";
  bool require_gpu = false;
  std::string pass_execution = "auto";
  std::string shader_dir;
  std::string cache_dir;  // "": the user's cache folder
  double cache_limit_mib = 2048;
  std::string log_level = "warn";
  std::string height_map_dir;  // "": none
  std::string volume_dir;      // "": none
};

// --egl-device, --require-gpu, --pass-execution, --shader-dir, --cache-dir, --cache-limit-mib, --height-map-dir,
// --volume-dir, --log-level
void add_gpu_options(CLI::App& command, GpuOptions& options);
// The files that a document names lie beside it unless the user said where. `cloudscape`: a name, or a document's path.
void look_beside(GpuOptions& options, const std::string& cloudscape);

std::uint64_t bytes_of_mib(double mib);
std::filesystem::path cache_folder(const std::string& cache_dir);

struct GpuStack {
  explicit GpuStack(const GpuOptions& options, bake::BakeStore::Progress progress = {});
  gpu::Context context;
  gpu::ShaderLibrary shaders;
  bake::BakeStore bakes;
  render::Renderer renderer;
};

// Progress of a bake as one line on stderr, rewritten in place on a terminal.
bake::BakeStore::Progress progress_on_stderr();

}  // namespace cloudscape::app
