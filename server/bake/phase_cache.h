// Phase tables on disk, beside the bakes: one file a recipe, named by its key.
#pragma once
#include <filesystem>
#include <optional>

#include "bake/kept_files.h"
#include "bake/phase_table.h"

namespace cloudscape::bake {

class PhaseCache {
 public:
  explicit PhaseCache(KeptFiles files) : files_(std::move(files)) {}
  std::optional<PhaseTable> load(const PhaseRecipe& recipe) const;  // nullopt if it is not there
  void store(const PhaseTable& table) const;
  std::filesystem::path path_of(const PhaseRecipe& recipe) const;

 private:
  KeptFiles files_;
};

}  // namespace cloudscape::bake
