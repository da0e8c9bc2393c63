// `cloudscape bake`: the textures of a cloudscape as EXR slice atlases, or only into the cache.
#include <fstream>

#include "app/bake_cost.h"
#include "app/commands.h"
#include "app/gpu_stack.h"
#include "core/error.h"
#include "core/log.h"
#include "core/version.h"
#include "encode/slice_atlas.h"
#include "settings/cloudscape_json.h"

namespace cloudscape::app {
namespace {

struct BakeOptions {
  GpuOptions gpu;
  std::string cloudscape, folder;
  bool verbose = false;
};

void write(const std::filesystem::path& path, const std::vector<std::uint8_t>& bytes) {
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) throw Error("cannot write " + path.string() + ": is the folder there, and the disk not full?");
}

int run_bake(const BakeOptions& options) {
  log::start(options.gpu.log_level);
  const settings::CloudscapeLibrary library{{}};
  const auto cloudscape = settings::find_cloudscape(library, options.cloudscape);
  GpuStack stack(options.gpu, progress_on_stderr());
  const bake::BakeRecipe recipe = bake::bake_recipe(*cloudscape);
  if (options.verbose) print_bake_costs(stack, options.gpu, *cloudscape);
  const bake::BakedTexels texels = stack.bakes.texels(recipe);
  if (options.folder.empty()) return 0;
  std::filesystem::create_directories(options.folder);
  const std::map<std::string, std::string> attributes{{"cloudscape", settings::to_json(*cloudscape)},
                                                      {"bakeKey", bake::bake_key(recipe)},
                                                      {"program", std::string("cloudscape ") + version}};
  const std::filesystem::path folder = options.folder;
  write(folder / "shape.exr",
        encode::slice_atlas_exr(texels.shape, recipe.resolution, recipe.resolution, attributes, recipe.format));
  write(folder / "detail.exr",
        encode::slice_atlas_exr(texels.detail, recipe.detail_resolution, recipe.detail_resolution, attributes));
  std::printf("%s/shape.exr %s/detail.exr\n", options.folder.c_str(), options.folder.c_str());
  return 0;
}

}  // namespace

void add_bake(CLI::App& program, Run& run) {
  auto options = std::make_shared<BakeOptions>();
  CLI::App* command = program.add_subcommand("bake", "Bake a cloudscape's textures into the cache, and into files");
  command->add_option("cloudscape", options->cloudscape, "Name of a cloudscape, or a document's path")->required();
  command->add_option("--out", options->folder, "Folder for shape.exr and detail.exr, slices side by side");
  command->add_flag("--verbose", options->verbose,
                    "Bake in both volume formats and tell what each costs: texels, bytes, times");
  add_gpu_options(*command, options->gpu);
  command->callback([options, &run] { run = [options] { return run_bake(*options); }; });
}

}  // namespace cloudscape::app
