#include "bake/grid_reader.h"

#include <chrono>

#include "bake/volume_file.h"
#include "core/beside_frames.h"
#include "core/content_hash.h"
#include "core/error.h"

namespace cloudscape::bake {
namespace {

// What is wrong with an OpenVDB file does not depend on how its voxels are wanted: it is read once and not once for
// each way, since OpenVDB does not free what it has read of a damaged tree.
std::string failure_key(GridRecipe recipe) {
  recipe.tiling = false, recipe.interpolation = {};
  recipe.resolution = 0, recipe.up = {};
  return content_hash(recipe);
}

}  // namespace

void GridReader::check(const BakeRecipe& recipe) const {
  if (const auto failure = failures_.find(failure_key(recipe.grid)); failure != failures_.end())
    throw UnusableFile(failure->second);
}

std::optional<std::pair<std::string, BakedTexels>> GridReader::advance(const std::string& key,
                                                                       const BakeRecipe& recipe) {
  check(recipe);
  if (!texels_.valid()) {
    key_ = key, recipe_ = recipe;
    texels_ = beside_frames(
        [recipe, folder = folder_] { return grid_texels(recipe, read_volume_file(folder, recipe.grid)); });
  }
  constexpr auto patience = std::chrono::milliseconds(10);
  if (texels_.wait_for(patience) != std::future_status::ready) return std::nullopt;
  try {
    return std::pair(key_, texels_.get());
  } catch (const std::exception& error) {
    remember_failure(error.what());
    return std::nullopt;
  }
}

void GridReader::remember_failure(const std::string& message) {
  constexpr std::size_t most_failures = 64;
  if (failures_.size() >= most_failures) failures_.erase(failures_.begin());
  failures_[failure_key(recipe_.grid)] = message;
}

}  // namespace cloudscape::bake
