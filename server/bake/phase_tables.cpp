#include "bake/phase_tables.h"

#include <algorithm>
#include <numbers>
#include <thread>

#include "bake/mie_phase.h"
#include "core/beside_frames.h"
#include "core/log.h"

namespace cloudscape::bake {
namespace {

constexpr std::size_t most_kept = 8;  // tuned: 25 kB each on the device; a server shows a few skies at a time
constexpr std::size_t most_jobs = 2;
// tuned: a viewer asks for its frame many times a second. Who has not asked for so long has gone, or moved a slider on.
constexpr auto forgotten_after = std::chrono::seconds(2);
constexpr auto longest_wait = std::chrono::milliseconds(5);

// Half the cores, so that frames are rendered meanwhile.
int threads_beside_frames() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / 2); }

std::shared_ptr<const PhaseTexture> uploaded(const PhaseTable& table) {
  constexpr int width = static_cast<int>(phase_table_texels);
  std::vector<float> texels;
  for (std::size_t i = 0; i < phase_table_texels; ++i) {
    for (const std::vector<double>& colour : table.phase_per_sr) texels.push_back(static_cast<float>(colour[i]));
    texels.push_back(0);
  }
  auto uploaded = std::make_shared<PhaseTexture>();
  uploaded->texture = gpu::Texture(gpu::Format::rgba32f, width, 1, "phase table");
  uploaded->texture.sample_with(gpu::Filter::linear, gpu::Wrap::clamp);
  uploaded->texture.upload({reinterpret_cast<const std::uint8_t*>(texels.data()), texels.size() * sizeof(float)});
  uploaded->mean_asymmetry_g = table.mean_asymmetry_g();
  return uploaded;
}

template <class Entry>
void keep(std::list<Entry>& entries, Entry entry) {
  entries.push_front(std::move(entry));
  while (entries.size() > most_kept) entries.pop_back();
}

}  // namespace

PhaseTables::~PhaseTables() {
  for (Job& job : jobs_) job.stop.request_stop();
}

std::shared_ptr<const PhaseTexture> PhaseTables::find(const PhaseRecipe& recipe, double sun_radius_deg) {
  const std::string key = phase_key(recipe) + std::to_string(sun_radius_deg);
  const auto found =
      std::find_if(textures_.begin(), textures_.end(), [&](const Kept& kept) { return kept.key == key; });
  if (found != textures_.end()) {
    textures_.splice(textures_.begin(), textures_, found);
    return found->texture;
  }
  const auto table = table_of(recipe);
  if (!table) return nullptr;
  keep(textures_, {key, uploaded(seen_by_disc(*table, sun_radius_deg * std::numbers::pi / 180))});
  return textures_.front().texture;
}

std::optional<PhaseTable> PhaseTables::table_of(const PhaseRecipe& recipe) {
  const auto known = std::find_if(tables_.begin(), tables_.end(), [&](const auto& t) { return t.recipe == recipe; });
  if (known != tables_.end()) return *known;
  const bool computing = std::any_of(jobs_.begin(), jobs_.end(), [&](const Job& job) { return job.recipe == recipe; });
  std::optional<PhaseTable> table = computing ? result_of(recipe) : cache_.load(recipe);
  if (table) keep(tables_, *table);
  if (!table && !computing) start(recipe);
  return table;
}

std::optional<PhaseTable> PhaseTables::result_of(const PhaseRecipe& recipe) {
  const auto job = std::find_if(jobs_.begin(), jobs_.end(), [&](const Job& each) { return each.recipe == recipe; });
  job->asked = Clock::now();
  if (job->result.wait_for(longest_wait) != std::future_status::ready) return std::nullopt;
  std::future<std::optional<PhaseTable>> result = std::move(job->result);
  jobs_.erase(job);
  std::optional<PhaseTable> table = result.get();
  if (table) cache_.store(*table);
  return table;
}

void PhaseTables::start(const PhaseRecipe& recipe) {
  drop_the_forgotten();
  if (jobs_.size() >= most_jobs) return std::this_thread::sleep_for(longest_wait);
  log::info("computing the phase function of droplets of {} um", recipe.effective_radius_um);
  Job job{recipe, {}, {}, Clock::now()};
  job.result = beside_frames([recipe, token = job.stop.get_token()] {
    return mie_phase_table(recipe, {.threads = threads_beside_frames()}, token);
  });
  jobs_.push_back(std::move(job));
}

void PhaseTables::drop_the_forgotten() {
  const auto now = Clock::now();
  jobs_.remove_if([&](Job& job) {
    if (now - job.asked < forgotten_after) return false;
    job.stop.request_stop();  // its end is waited for: tens of milliseconds
    return true;
  });
}

}  // namespace cloudscape::bake
