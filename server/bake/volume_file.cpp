#include "bake/volume_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/gtc/packing.hpp>

#include "core/error.h"
#include "vdb/vdb_file.h"

namespace cloudscape::bake {
namespace {

namespace fs = std::filesystem;

void check_densities(const Voxels& voxels) {
  float greatest = 0;
  for (const float density : voxels.densities) {
    if (!std::isfinite(density))
      throw UnusableFile("holds densities that are not finite: repair it in the program that made it");
    if (density < 0) throw UnusableFile("holds negative densities: clamp them in the program that made it");
    greatest = std::max(greatest, density);
  }
  if (greatest <= 0) throw UnusableFile("is empty: no density in it is above 0");
}

Voxels read(const fs::path& file, const GridRecipe& recipe) {
  const glm::ivec3 size(recipe.size[0], recipe.size[1], recipe.size[2]);
  if (recipe.vdb) return vdb::read(file, {recipe.name, recipe.resolution, recipe.up});
  return recipe.file.ends_with(".raw") ? detail::read_raw_volume(file, size) : detail::read_exr_volume(file, size);
}

std::string size_text(const glm::ivec3& size) {
  return std::to_string(size.x) + "x" + std::to_string(size.y) + "x" + std::to_string(size.z);
}

}  // namespace

namespace detail {

Voxels read_raw_volume(const fs::path& file, const glm::ivec3& size) {
  const std::uintmax_t expected = count_of(size) * sizeof(float);
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(file, error);
  if (error || bytes != expected)
    throw UnusableFile("has " + std::to_string(error ? 0 : bytes) + " bytes, and " + size_text(size) +
                       " voxels of 32 bits have " + std::to_string(expected) + ": correct volume.grid.size");
  Voxels voxels{size, std::vector<float>(count_of(size))};
  std::ifstream in(file, std::ios::binary);
  if (!in.read(reinterpret_cast<char*>(voxels.densities.data()), static_cast<std::streamsize>(expected)))
    throw UnusableFile("cannot be read: give the server the right to read it");
  return voxels;
}

}  // namespace detail

Voxels read_volume_file(const fs::path& folder, const GridRecipe& recipe) {
  const std::string what = "the volume '" + recipe.file + "' ";
  if (recipe.vdb ? !is_vdb_name(recipe.file) : !is_grid_name(recipe.file))
    throw UnusableFile(what + "is no bare name of a " + (recipe.vdb ? ".vdb" : ".raw or .exr") + " file");
  if (folder.empty())
    throw UnusableFile(what + "cannot be read: there is no folder of volumes, name one with --volume-dir");
  const fs::path file = folder / recipe.file;
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    throw UnusableFile(what + "is not in the folder of volumes: put it there, or name another");
  try {
    Voxels voxels = read(file, recipe);
    check_densities(voxels);
    return voxels;
  } catch (const std::bad_alloc&) {
    throw UnusableFile(what + "needs more memory than there is: make it smaller");
  } catch (const Error& reason) {
    throw UnusableFile(what + reason.what());
  }
}

BakedTexels grid_texels(const BakeRecipe& recipe, const Voxels& voxels) {
  BakedTexels texels{recipe, {}, std::vector<std::uint8_t>(4), {}};
  texels.shape.resize(2 * voxels.densities.size());
  texels.variation.resize(std::size_t{8} * variation_resolution * variation_resolution);
  GridFacts facts{voxels.size, *std::ranges::max_element(voxels.densities), voxels.low, voxels.high, {}};
  facts.slice_maxima.resize(static_cast<std::size_t>(voxels.size.z));
  const std::size_t slice = voxels.densities.size() / facts.slice_maxima.size();
  for (std::size_t i = 0; i < voxels.densities.size(); ++i) {
    const auto share = static_cast<float>(voxels.densities[i] / facts.greatest_density);
    const std::uint16_t half = glm::packHalf1x16(share);
    texels.shape[2 * i] = static_cast<std::uint8_t>(half & 255);
    texels.shape[2 * i + 1] = static_cast<std::uint8_t>(half >> 8);
    facts.slice_maxima[i / slice] = std::max(facts.slice_maxima[i / slice], share);
  }
  texels.grid = std::move(facts);
  return texels;
}

}  // namespace cloudscape::bake
