// Bakes on disk: one file a recipe, named by its key, written atomically, checked when read, the least recently used
// ones removed when there are too many bytes.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>

#include "bake/baked_cloudscape.h"

namespace cloudscape::bake {

class BakeCache {
 public:
  // `folder` is made if it is missing; an empty path keeps nothing. A folder that cannot be written is told once in the
  // log.
  BakeCache(std::filesystem::path folder, std::uint64_t limit_bytes);
  // nullopt if it is not there; a damaged or truncated file is told in the log and removed.
  std::optional<BakedTexels> load(const BakeRecipe& recipe) const;
  void store(const BakedTexels& texels) const;  // failure to write is told in the log, no more
  std::filesystem::path path_of(const BakeRecipe& recipe) const;

 private:
  void evict() const;
  std::filesystem::path folder_;
  std::uint64_t limit_bytes_;
};

}  // namespace cloudscape::bake
