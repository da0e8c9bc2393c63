#include "bake/grid_recipe.h"

namespace cloudscape::bake {
GridRecipe grid_recipe(const Volume& volume, const std::filesystem::path& folder) {
  const VolumeGrid& grid = volume.grid;
  GridRecipe recipe;
  recipe.file = grid.file;
  recipe.vdb = volume.kind == VolumeKind::vdb;
  if (recipe.vdb) {
    recipe.name = grid.name, recipe.resolution = grid.resolution, recipe.up = grid.up;
  } else {
    recipe.size = grid.size;
  }
  recipe.tiling = grid.tiling, recipe.interpolation = grid.interpolation;
  recipe.stamp = file_stamp(folder / grid.file);
  return recipe;
}

}  // namespace cloudscape::bake
