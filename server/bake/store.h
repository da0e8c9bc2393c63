// Baked cloudscapes at hand: in memory, from the disk, or being baked.
#pragma once
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>

#include "bake/baker.h"
#include "bake/cache.h"
#include "bake/grid_reader.h"
#include "bake/phase_tables.h"

namespace cloudscape::bake {

class BakeStore {
 public:
  using Progress = std::function<void(const BakeRecipe& recipe, double share)>;  // 0..1; 1 once, at the end
  // `limit_bytes`: textures that are kept on the device beside those in use. `volumes`: the folder of the files that
  // volumes may name; empty: none.
  BakeStore(const gpu::Context& context, gpu::ShaderLibrary& shaders, BakeCache cache, std::uint64_t limit_bytes,
            Progress progress = {}, std::filesystem::path volumes = {});
  ~BakeStore();

  BakeRecipe recipe_of(const Cloudscape& cloudscape) const { return bake_recipe(cloudscape, grids_.folder()); }
  // The baked form, from memory or disk; nullptr: call `advance` until it is there. Throws UnusableFile for a volume's
  // file that cannot be used. What is read from such a file is not kept on disk: it lies there already.
  std::shared_ptr<const BakedCloudscape> find(const BakeRecipe& recipe);
  // Bakes the next slab of it. Four bakes are under way at most: a fifth waits until one is done, or until one has not
  // been advanced for a while; that one is given up.
  void advance(const BakeRecipe& recipe);
  // Waits for the whole bake.
  std::shared_ptr<const BakedCloudscape> get(const BakeRecipe& recipe);
  // The texels themselves, for export.
  BakedTexels texels(const BakeRecipe& recipe);
  std::size_t bytes() const;
  PhaseTables& phases() { return phases_; }  // kept in the same folder
  const KeptFiles& files() const { return cache_.files(); }

 private:
  struct Entry {
    std::string key;
    std::shared_ptr<const BakedCloudscape> baked;
  };
  std::shared_ptr<const BakedCloudscape> keep(const std::string& key, BakedTexels texels);
  void advance_reading(const std::string& key, const BakeRecipe& recipe);
  Baker baker_;
  BakeCache cache_;
  PhaseTables phases_;
  GridReader grids_;
  std::uint64_t limit_bytes_;
  Progress progress_;
  std::list<Entry> entries_;  // most recently used first
  struct Job {
    std::unique_ptr<BakeJob> job;
    std::uint64_t advanced = 0;  // when last, in calls of advance
  };
  bool make_room_for_a_job();
  std::map<std::string, Job> jobs_;
  std::uint64_t advances_ = 0;
};

}  // namespace cloudscape::bake
