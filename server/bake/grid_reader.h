// Volume files that are being read, on a thread of their own and one at a time: they may be large.
#pragma once
#include <future>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "bake/baked_cloudscape.h"

namespace cloudscape::bake {

class GridReader {
 public:
  explicit GridReader(std::filesystem::path folder) : folder_(std::move(folder)) {}  // empty: there is none
  const std::filesystem::path& folder() const { return folder_; }
  // Throws UnusableFile if reading its file failed; again at each call until the file changes.
  void check(const BakeRecipe& recipe) const;
  // Goes on for some milliseconds. What has been read, by its key: this file, or the one that was read before.
  std::optional<std::pair<std::string, BakedTexels>> advance(const std::string& key, const BakeRecipe& recipe);

 private:
  void remember_failure(const std::string& message);
  std::filesystem::path folder_;
  std::string key_;  // of what is being read
  BakeRecipe recipe_;
  std::future<BakedTexels> texels_;
  std::map<std::string, std::string> failures_;
};

}  // namespace cloudscape::bake
