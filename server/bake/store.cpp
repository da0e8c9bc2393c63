#include "bake/store.h"

#include <algorithm>

#include "core/log.h"

namespace cloudscape::bake {

BakeStore::BakeStore(const gpu::Context& context, gpu::ShaderLibrary& shaders, BakeCache cache,
                     std::uint64_t limit_bytes, Progress progress, std::filesystem::path volumes)
    : baker_(context, shaders),
      cache_(std::move(cache)),
      phases_(PhaseCache(cache_.files())),
      grids_(std::move(volumes)),
      limit_bytes_(limit_bytes),
      progress_(std::move(progress)) {}
BakeStore::~BakeStore() = default;

std::shared_ptr<const BakedCloudscape> BakeStore::find(const BakeRecipe& recipe) {
  const std::string key = bake_key(recipe);
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.key == key; });
  if (found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
    return found->baked;
  }
  if (!recipe.grid.file.empty()) {
    grids_.check(recipe);
    return nullptr;
  }
  if (jobs_.contains(key)) return nullptr;
  auto texels = cache_.load(recipe);
  return texels ? keep(key, std::move(*texels)) : nullptr;
}

std::shared_ptr<const BakedCloudscape> BakeStore::keep(const std::string& key, BakedTexels texels) {
  entries_.push_front({key, std::make_shared<const BakedCloudscape>(std::move(texels))});
  while (entries_.size() > 1 && bytes() > limit_bytes_) entries_.pop_back();
  return entries_.front().baked;
}

// Whoever left a bake unfinished may have gone for good: the one that was advanced the longest ago makes room, but only
// when it has waited long. Were it dropped at once, five bakes that are advanced in turn would drop one another
// forever.
bool BakeStore::make_room_for_a_job() {
  constexpr std::size_t most_jobs = 4;
  constexpr std::uint64_t patience = 32;  // tuned: in slabs of all bakes; a second or two without a GPU
  if (jobs_.size() < most_jobs) return true;
  const auto oldest = std::ranges::min_element(jobs_, {}, [](const auto& entry) { return entry.second.advanced; });
  if (advances_ - oldest->second.advanced < patience) return false;
  jobs_.erase(oldest);
  return true;
}

void BakeStore::advance(const BakeRecipe& recipe) {
  const std::string key = bake_key(recipe);
  if (!recipe.grid.file.empty()) return advance_reading(key, recipe);
  ++advances_;
  if (!jobs_.contains(key)) {
    if (!make_room_for_a_job()) return;
    jobs_[key].job = baker_.begin(recipe);
  }
  jobs_[key].advanced = advances_;
  BakeJob* job = jobs_[key].job.get();
  const bool done = job->advance();
  if (!done) {
    if (progress_) progress_(recipe, std::min(job->progress(), 0.999));
    return;
  }
  BakedTexels texels = job->texels();
  if (progress_) progress_(recipe, 1.0);
  jobs_.erase(key);
  cache_.store(texels);
  keep(key, std::move(texels));
}

void BakeStore::advance_reading(const std::string& key, const BakeRecipe& recipe) {
  if (auto read = grids_.advance(key, recipe)) keep(read->first, std::move(read->second));
}

std::shared_ptr<const BakedCloudscape> BakeStore::get(const BakeRecipe& recipe) {
  for (;;) {
    if (auto baked = find(recipe)) return baked;
    advance(recipe);
  }
}

BakedTexels BakeStore::texels(const BakeRecipe& recipe) {
  if (auto cached = cache_.load(recipe)) return *cached;
  return get(recipe)->texels();
}

std::size_t BakeStore::bytes() const {
  std::size_t sum = 0;
  for (const Entry& entry : entries_) sum += entry.baked->bytes();
  return sum;
}

}  // namespace cloudscape::bake
