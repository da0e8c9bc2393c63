// `cloudscape bake`: the textures of a cloudscape as EXR slice atlases, its density as OpenVDB, or only into the cache.
#include <fstream>

#include "app/bake_cost.h"
#include "app/bake_vdb.h"
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
  VdbOptions vdb;
  bool verbose = false;
};

void write(const std::filesystem::path& path, const std::vector<std::uint8_t>& bytes) {
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) throw Error("cannot write " + path.string() + ": is the folder there, and the disk not full?");
}

void write_atlases(const BakeOptions& options, const Cloudscape& cloudscape, const bake::BakedTexels& texels) {
  const bake::BakeRecipe& recipe = texels.recipe;
  std::filesystem::create_directories(options.folder);
  const std::map<std::string, std::string> attributes{{"cloudscape", settings::to_json(cloudscape)},
                                                      {"bakeKey", bake::bake_key(recipe)},
                                                      {"program", std::string("cloudscape ") + version}};
  const std::filesystem::path folder = options.folder;
  write(folder / "shape.exr",
        encode::slice_atlas_exr(texels.shape, recipe.resolution, recipe.resolution, attributes, recipe.format));
  write(folder / "detail.exr",
        encode::slice_atlas_exr(texels.detail, recipe.detail_resolution, recipe.detail_resolution, attributes));
  std::printf("%s/shape.exr %s/detail.exr\n", options.folder.c_str(), options.folder.c_str());
}

int run_bake(BakeOptions options) {
  log::start(options.gpu.log_level);
  look_beside(options.gpu, options.cloudscape);
  const settings::CloudscapeLibrary library{{}};
  const auto cloudscape = settings::find_cloudscape(library, options.cloudscape);
  if (is_from_file(cloudscape->volume.kind) && (options.verbose || !options.folder.empty()))
    throw InvalidInput(options.verbose ? "--verbose" : "--out",
                       "is for volumes that are baked, and this one comes from a file: use --vdb");
  GpuStack stack(options.gpu, progress_on_stderr());
  if (options.verbose) print_bake_costs(stack, options.gpu, *cloudscape);
  if (!options.vdb.file.empty()) bake_vdb(stack, *cloudscape, options.vdb);
  const bake::BakedTexels texels = stack.bakes.texels(stack.bakes.recipe_of(*cloudscape));
  if (!options.folder.empty()) write_atlases(options, *cloudscape, texels);
  return 0;
}

}  // namespace

void add_bake(CLI::App& program, Run& run) {
  auto options = std::make_shared<BakeOptions>();
  CLI::App* command = program.add_subcommand("bake", "Bake a cloudscape's textures into the cache, and into files");
  command->add_option("cloudscape", options->cloudscape, "Name of a cloudscape, or a document's path")->required();
  command->add_option("--out", options->folder, "Folder for shape.exr and detail.exr, slices side by side");
  command->add_option("--vdb", options->vdb.file,
                      "OpenVDB file for the final density, detail included: a fog volume `density` in metres, with "
                      "extinction_per_m as its metadata");
  command->add_option("--vdb-resolution", options->vdb.resolution, "Cubic voxels along the volume's longest side")
      ->capture_default_str()
      ->check(CLI::Range(8, 2048));
  command
      ->add_option("--vdb-up", options->vdb.up, "Upward axis: z, as in Blender (x east, y north), or y, as in Houdini")
      ->capture_default_str()
      ->check(CLI::IsMember({"y", "z"}));
  command->add_flag(
      "--verbose", options->verbose,
      "Bake in both volume formats (several layers: in theirs) and tell what each costs: texels, bytes, times");
  add_gpu_options(*command, options->gpu);
  command->callback([options, &run] { run = [options] { return run_bake(*options); }; });
}

}  // namespace cloudscape::app
