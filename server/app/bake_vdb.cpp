#include "app/bake_vdb.h"

#include <unistd.h>

#include <cstdio>

#include "core/version.h"
#include "core/voxels.h"
#include "render/density_export.h"
#include "settings/cloudscape_json.h"
#include "settings/text_file.h"
#include "vdb/vdb_file.h"

namespace cloudscape::app {
namespace {

void tell(int slice, int slices) {
  if (isatty(STDERR_FILENO) == 0) return;
  std::fprintf(stderr, "\rwriting voxels: %d %%%s", 100 * slice / slices, slice == slices ? "\n" : "");
  std::fflush(stderr);
}

void print(const render::DensityExport& density, const VdbOptions& options) {
  const glm::ivec3& size = density.size();
  std::printf("%s: %dx%dx%d voxels of %g m, %s up; extinction_per_m %g where density is 1\n", options.file.c_str(),
              size.x, size.y, size.z, density.voxel_m(), options.up.c_str(), density.extinction_per_m());
}

}  // namespace

void bake_vdb(GpuStack& stack, const Cloudscape& cloudscape, const VdbOptions& options) {
  settings::check_writable(options.file);
  const auto baked = stack.bakes.get(stack.bakes.recipe_of(cloudscape));
  render::DensityExport density(stack.shaders, cloudscape, *baked, options.resolution);
  vdb::Writer writer(density.voxel_m(), density.low_m() + 0.5 * density.voxel_m(),
                     options.up == "y" ? UpAxis::y : UpAxis::z);
  for (int z = 0; z < density.size().z; z += render::DensityExport::slab) {
    writer.add(z, density.size().x, density.size().y, density.slices(z));
    tell(std::min(z + render::DensityExport::slab, density.size().z), density.size().z);
  }
  const Medium& medium = cloudscape.medium;
  writer.write(options.file,
               {{"creator", std::string("cloudscape ") + version}, {"cloudscape", settings::to_json(cloudscape)}},
               {{"extinction_per_m", density.extinction_per_m()},
                {"single_scattering_albedo", medium.single_scattering_albedo},
                {"asymmetry_g", medium.phase.asymmetry_g}});
  print(density, options);
}

}  // namespace cloudscape::app
