// Volumes from files: OpenVDB, raw floats and EXR slice atlases, checked as files of strangers.
#pragma once
#include <filesystem>

#include "bake/baked_cloudscape.h"
#include "core/voxels.h"

namespace cloudscape::bake {

// Reads the file of `recipe` in `folder`. Throws UnusableFile, one sentence that names the file and the remedy: it is
// missing, damaged, cut off, empty, too large, not of the size that the document says, or has densities that are
// negative or not finite. Thread-safe.
Voxels read_volume_file(const std::filesystem::path& folder, const GridRecipe& recipe);

// The voxels as the texels that the march samples: shares of the greatest density.
BakedTexels grid_texels(const BakeRecipe& recipe, const Voxels& voxels);

namespace detail {
Voxels read_raw_volume(const std::filesystem::path& file, const glm::ivec3& size);
Voxels read_exr_volume(const std::filesystem::path& file, const glm::ivec3& size);
}  // namespace detail

}  // namespace cloudscape::bake
