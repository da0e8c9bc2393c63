// Phase tables at hand: as textures, in memory, from the disk, or being computed beside the frames.
#pragma once
#include <chrono>
#include <future>
#include <list>
#include <memory>
#include <stop_token>
#include <string>

#include "bake/phase_cache.h"
#include "gpu/texture.h"

namespace cloudscape::bake {

struct PhaseTexture {
  gpu::Texture texture;  // phase_table_texels wide, 1 high; red, green, blue in 1/sr
  double mean_asymmetry_g = 0;
};

// On the thread of the context, as all that owns textures.
class PhaseTables {
 public:
  explicit PhaseTables(PhaseCache cache) : cache_(std::move(cache)) {}
  ~PhaseTables();  // stops what is being computed
  PhaseTables(const PhaseTables&) = delete;
  PhaseTables& operator=(const PhaseTables&) = delete;

  // The table as a sun of this radius shows it. nullptr: it is being computed; ask again. Waits some milliseconds at
  // most, so that asking again and again costs nothing.
  std::shared_ptr<const PhaseTexture> find(const PhaseRecipe& recipe, double sun_radius_deg);
  // The table itself; nullopt: it is being computed, as above.
  std::optional<PhaseTable> table_of(const PhaseRecipe& recipe);
  std::size_t jobs() const { return jobs_.size(); }  // tables being computed

 private:
  using Clock = std::chrono::steady_clock;
  struct Kept {
    std::string key;
    std::shared_ptr<const PhaseTexture> texture;
  };
  struct Job {
    PhaseRecipe recipe;
    std::stop_source stop;
    std::future<std::optional<PhaseTable>> result;
    Clock::time_point asked;  // last
  };
  std::optional<PhaseTable> result_of(const PhaseRecipe& recipe);
  void start(const PhaseRecipe& recipe);
  void drop_the_forgotten();

  PhaseCache cache_;
  std::list<Kept> textures_;      // most recently used first
  std::list<PhaseTable> tables_;  // the same
  std::list<Job> jobs_;
};

}  // namespace cloudscape::bake
