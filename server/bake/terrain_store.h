// Baked terrains at hand: in memory, or being baked. The noise of their heights is kept on disk.
#pragma once
#include <filesystem>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>

#include "bake/terrain.h"

namespace cloudscape::bake {

class TerrainStore {
 public:
  // `folder`: of the height maps; empty: there are none. `files`: where noise is kept from run to run.
  TerrainStore(const gpu::Context& context, gpu::ShaderLibrary& shaders, std::filesystem::path folder, KeptFiles files);
  TerrainRecipe recipe_of(const Cloudscape& cloudscape) const { return terrain_recipe(cloudscape, folder_); }
  // nullptr: call `advance` until it is there. Throws Error for a height map that cannot be used, again at each call
  // until the file changes.
  std::shared_ptr<const BakedTerrain> find(const TerrainRecipe& recipe);
  void advance(const TerrainRecipe& recipe);  // bakes the next slice of it
  std::size_t bytes() const;
  void reload(gpu::ShaderLibrary& shaders);

 private:
  void keep(const std::string& key, std::shared_ptr<const BakedTerrain> baked);
  void remember_failure(const std::string& key, const std::string& message);
  std::filesystem::path folder_;
  KeptFiles files_;
  gpu::ScreenPass noise_;
  std::list<std::pair<std::string, std::shared_ptr<const BakedTerrain>>> entries_;  // most recently used first
  std::map<std::string, std::unique_ptr<TerrainJob>> jobs_;
  std::map<std::string, std::string> failures_;
};

}  // namespace cloudscape::bake
