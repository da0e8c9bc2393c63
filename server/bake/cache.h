// Bakes on disk: one file a recipe, named by its key.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>

#include "bake/baked_cloudscape.h"
#include "bake/kept_files.h"

namespace cloudscape::bake {

class BakeCache {
 public:
  BakeCache(std::filesystem::path folder, std::uint64_t limit_bytes) : files_(std::move(folder), limit_bytes) {}
  std::optional<BakedTexels> load(const BakeRecipe& recipe) const;  // nullopt if it is not there
  void store(const BakedTexels& texels) const;
  std::filesystem::path path_of(const BakeRecipe& recipe) const;
  const KeptFiles& files() const { return files_; }

 private:
  KeptFiles files_;
};

}  // namespace cloudscape::bake
