#include "app/bake_cost.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "app/temporary_folder.h"
#include "bake/baker.h"

namespace cloudscape::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct Cost {
  bake::BakeRecipe recipe;
  std::uint64_t device_bytes = 0, disk_bytes = 0;
  double bake_s = 0, load_s = 0;
};

bake::BakedTexels baked(GpuStack& stack, const bake::BakeRecipe& recipe) {
  const bake::Baker baker(stack.context, stack.shaders);
  const std::unique_ptr<bake::BakeJob> job = baker.begin(recipe);
  const bake::BakeStore::Progress progress = progress_on_stderr();
  while (!job->advance()) {
    stack.context.finish();
    progress(recipe, std::min(job->progress(), 0.999));
  }
  progress(recipe, 1);
  return job->texels();
}

// The time of loading is that of a file that was written just now: of the disk's own speed it says nothing.
void measure_loading(GpuStack& stack, const bake::BakedTexels& texels, Cost& cost) {
  const TemporaryFolder folder;
  const bake::BakeCache cache(folder.path(), UINT64_MAX);
  cache.store(texels);
  std::error_code error;
  cost.disk_bytes = fs::file_size(cache.path_of(cost.recipe), error);
  if (error) cost.disk_bytes = 0;
  const auto start = Clock::now();
  const auto loaded = cache.load(cost.recipe);
  cost.device_bytes = bake::BakedCloudscape(loaded ? *loaded : texels).bytes();
  stack.context.finish();
  cost.load_s = seconds_since(start);
}

Cost cost_of(GpuStack& stack, const Cloudscape& cloudscape, VolumeFormat format, const bake::BakeCache& keep) {
  Cloudscape asked = cloudscape;
  asked.volume.format = format;
  Cost cost{bake::bake_recipe(asked)};
  const auto start = Clock::now();
  const bake::BakedTexels texels = baked(stack, cost.recipe);
  cost.bake_s = seconds_since(start);
  measure_loading(stack, texels, cost);
  if (format == cloudscape.volume.format) keep.store(texels);
  return cost;
}

void print(const Cost& cost) {
  const std::string side = std::to_string(cost.recipe.resolution);
  const std::string format(name_of(cost.recipe.format));
  std::printf("%-8s %-14s %14llu %14llu %10.3f %10.3f\n", format.c_str(), (side + "x" + side + "x" + side).c_str(),
              static_cast<unsigned long long>(cost.device_bytes), static_cast<unsigned long long>(cost.disk_bytes),
              cost.bake_s, cost.load_s);
}

}  // namespace

void print_bake_costs(GpuStack& stack, const GpuOptions& options, const Cloudscape& cloudscape) {
  const bake::BakeCache keep(cache_folder(options.cache_dir), bytes_of_mib(options.cache_limit_mib));
  const VolumeFormat own = cloudscape.volume.format;
  const VolumeFormat other = own == VolumeFormat::r16f ? VolumeFormat::rgba8 : VolumeFormat::r16f;
  std::printf("%-8s %-14s %14s %14s %10s %10s\n", "format", "texels", "device bytes", "disk bytes", "bake s", "load s");
  print(cost_of(stack, cloudscape, own, keep));
  if (!is_layered(cloudscape)) print(cost_of(stack, cloudscape, other, keep));
}

}  // namespace cloudscape::app
