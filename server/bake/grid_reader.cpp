#include "bake/grid_reader.h"

#include <chrono>

#include "bake/volume_file.h"
#include "core/error.h"

namespace cloudscape::bake {

void GridReader::check(const std::string& key) const {
  if (const auto failure = failures_.find(key); failure != failures_.end()) throw UnusableFile(failure->second);
}

std::optional<std::pair<std::string, BakedTexels>> GridReader::advance(const std::string& key,
                                                                       const BakeRecipe& recipe) {
  check(key);
  if (!texels_.valid()) {
    key_ = key;
    texels_ = std::async(std::launch::async, [recipe, folder = folder_] {
      return grid_texels(recipe, read_volume_file(folder, recipe.grid));
    });
  }
  constexpr auto patience = std::chrono::milliseconds(10);
  if (texels_.wait_for(patience) != std::future_status::ready) return std::nullopt;
  try {
    return std::pair(key_, texels_.get());
  } catch (const std::exception& error) {
    remember_failure(key_, error.what());
    return std::nullopt;
  }
}

void GridReader::remember_failure(const std::string& key, const std::string& message) {
  constexpr std::size_t most_failures = 64;
  if (failures_.size() >= most_failures) failures_.erase(failures_.begin());
  failures_[key] = message;
}

}  // namespace cloudscape::bake
