#include "bake/terrain_store.h"

#include <algorithm>

#include "core/error.h"

namespace cloudscape::bake {
namespace {

constexpr std::size_t limit_bytes = std::size_t{1} << 29;  // tuned: twenty terrains of 1024^2, one and a half of 4096^2
constexpr std::size_t most_jobs = 4;                       // whoever left a bake unfinished may have gone for good
constexpr std::size_t most_failures = 64;

// Makes room for one more beside `key`.
template <class Entries>
void bound(Entries& entries, const std::string& key, std::size_t most) {
  if (entries.size() < most || entries.contains(key)) return;
  entries.erase(entries.begin());
}

}  // namespace

TerrainStore::TerrainStore(const gpu::Context& context, gpu::ShaderLibrary& shaders, std::filesystem::path folder,
                           KeptFiles files)
    : folder_(std::move(folder)),
      files_(std::move(files)),
      noise_(context, shaders, "bake/terrain.glsl", {gpu::Format::r32f}) {}

std::shared_ptr<const BakedTerrain> TerrainStore::find(const TerrainRecipe& recipe) {
  const std::string key = terrain_key(recipe);
  if (const auto failure = failures_.find(key); failure != failures_.end()) throw UnusableFile(failure->second);
  const auto found = std::ranges::find(entries_, key, [](const auto& entry) { return entry.first; });
  if (found == entries_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found);
  return found->second;
}

void TerrainStore::advance(const TerrainRecipe& recipe) {
  const std::string key = terrain_key(recipe);
  bound(jobs_, key, most_jobs);
  std::unique_ptr<TerrainJob>& job = jobs_[key];
  try {
    if (!job) job = std::make_unique<TerrainJob>(noise_, recipe, folder_, files_);
    if (!job->advance()) return;
    keep(key, job->take());
    jobs_.erase(key);
  } catch (const std::exception& error) {
    jobs_.erase(key);
    if (!recipe.height_map.empty()) remember_failure(key, error.what());
    throw;
  }
}

void TerrainStore::remember_failure(const std::string& key, const std::string& message) {
  bound(failures_, key, most_failures);
  failures_[key] = message;
}

void TerrainStore::keep(const std::string& key, std::shared_ptr<const BakedTerrain> baked) {
  entries_.emplace_front(key, std::move(baked));
  while (entries_.size() > 1 && bytes() > limit_bytes) entries_.pop_back();
}

std::size_t TerrainStore::bytes() const {
  std::size_t sum = 0;
  for (const auto& [key, baked] : entries_) sum += baked->bytes();
  return sum;
}

void TerrainStore::reload(gpu::ShaderLibrary& shaders) {
  noise_.reload(shaders);
  std::erase_if(entries_, [](const auto& entry) { return entry.second->recipe().height_map.empty(); });
}

}  // namespace cloudscape::bake
