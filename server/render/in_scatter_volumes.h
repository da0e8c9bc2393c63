// In-scatter volumes at hand: as textures, or being solved beside the frames.
#pragma once
#include <atomic>
#include <chrono>
#include <future>
#include <list>
#include <memory>
#include <stop_token>
#include <string>

#include "bake/in_scatter.h"
#include "bake/light_cache.h"
#include "core/beside_frames.h"
#include "core/frame.h"
#include "render/in_scatter_extinction.h"
#include "render/sky_tables.h"

namespace cloudscape::render {

struct InScatterVolume {
  gpu::Texture mean, directed;  // shaders/render/in_scatter.glsl
  std::size_t bytes() const { return mean.bytes() + directed.bytes(); }
};

// On the thread of the context.
class InScatterVolumes {
 public:
  InScatterVolumes(gpu::ShaderLibrary& shaders, bake::LightCache cache);
  ~InScatterVolumes();  // stops what is being solved
  InScatterVolumes(const InScatterVolumes&) = delete;
  InScatterVolumes& operator=(const InScatterVolumes&) = delete;

  struct Wanted {
    const FrameRequest& request;
    std::shared_ptr<const bake::BakedCloudscape> baked;
    std::shared_ptr<const SkyTables::Lights> lights;
    double mean_cosine = 0;
    bool rests = false;  // the lights may be those of the sun before: solves nothing anew if there is any light
  };
  // The light of this sky in these clouds; of a request whose light may lag the newest there is, while this is being
  // solved, or else a first draft of it. nullptr: it is being solved; ask again. Waits some milliseconds at most.
  // Asking again for the same objects costs nothing. Binds other blocks.
  std::shared_ptr<const InScatterVolume> find(const Wanted& wanted);
  void reload(gpu::ShaderLibrary& shaders);

 private:
  using Clock = std::chrono::steady_clock;
  struct Clouds {  // what does not change with the light
    std::string key;
    InScatterPlan plan;
    std::shared_ptr<const Cloudscape> marched;
    InScatterGrids grids;                           // once light has to be solved in them
    std::shared_ptr<const InScatterVolume> newest;  // of any light
  };
  struct Question {  // what was asked for, and what that means
    std::shared_ptr<const Cloudscape> cloudscape;
    std::weak_ptr<const bake::BakedCloudscape> baked;
    std::weak_ptr<const SkyTables::Lights> lights;
    double mean_cosine = 0;
    std::shared_ptr<Clouds> clouds;
    bake::InScatterLight light;
    std::string key;
  };
  struct Draft {  // the light of one level, for all
    std::atomic<bool> ready = false;
    bake::LightTexels light;  // once it is
  };
  struct Job {
    std::string key;
    std::shared_ptr<Clouds> clouds;
    std::stop_source stop;
    std::future<std::optional<bake::LightTexels>> result;
    Clock::time_point asked;  // when somebody last wanted it
    std::shared_ptr<Draft> draft;
  };
  struct Kept {
    std::string key;
    std::shared_ptr<const InScatterVolume> volume;
  };
  const Question* known_question(const Wanted& wanted);  // nullptr: it is a new one
  const Question& ask(const Wanted& wanted, const std::shared_ptr<Clouds>& clouds);
  std::shared_ptr<Clouds> clouds_of(const Wanted& wanted);
  std::shared_ptr<const InScatterVolume> kept(const std::string& key);
  void keep(const std::string& key, Clouds& clouds, const bake::LightTexels& light);
  void take_results();
  static std::optional<bake::LightTexels> solve(const std::vector<bake::InScatterProblem>& levels, Beside beside,
                                                const std::stop_token& stop, Draft& draft);
  void stop_the_forgotten();
  Job* job_of(const std::string& key);
  Job* job_in(const Clouds& clouds);
  Job* start(const Question& question, const bake::BakedCloudscape& baked, Beside beside);

  InScatterExtinction extinction_;
  bake::LightCache cache_;
  std::list<Question> questions_;              // most recently asked first
  std::list<std::shared_ptr<Clouds>> clouds_;  // the same
  std::list<Kept> volumes_;                    // the same
  std::list<Job> jobs_;
};

}  // namespace cloudscape::render
