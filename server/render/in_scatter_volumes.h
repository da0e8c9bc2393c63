// In-scatter volumes at hand: as textures, or being solved beside the frames.
#pragma once
#include <chrono>
#include <future>
#include <list>
#include <memory>
#include <stop_token>
#include <string>

#include "bake/in_scatter.h"
#include "bake/light_cache.h"
#include "bake/structure.h"
#include "core/frame.h"
#include "gpu/pass.h"
#include "render/blocks.h"
#include "render/in_scatter_plan.h"
#include "render/sky_tables.h"

namespace cloudscape::render {

struct InScatterVolume {
  gpu::Texture mean, directed;  // shaders/render/in_scatter.glsl
};

// On the thread of the context.
class InScatterVolumes {
 public:
  InScatterVolumes(gpu::ShaderLibrary& shaders, bake::LightCache cache);
  ~InScatterVolumes();  // stops what is being solved
  InScatterVolumes(const InScatterVolumes&) = delete;
  InScatterVolumes& operator=(const InScatterVolumes&) = delete;

  struct Wanted {
    const FrameRequest& request;  // as marched
    const bake::BakedCloudscape& baked;
    const gpu::Texture& structure;
    const SkyTables::Lights& lights;
    double mean_cosine = 0;
  };
  // The light of this sky in these clouds; of a request whose light may lag the newest there is, while this is being
  // solved. nullptr: it is being solved; ask again. Waits some milliseconds at most.
  std::shared_ptr<const InScatterVolume> find(const Wanted& wanted);
  int solved() const { return solved_; }  // volumes so far
  void reload(gpu::ShaderLibrary& shaders);

 private:
  using Clock = std::chrono::steady_clock;
  struct Clouds {  // what does not change with the light
    std::string key;
    InScatterPlan plan;
    std::vector<bake::InScatterGrid> grids;         // by level
    std::shared_ptr<const InScatterVolume> newest;  // of any light
  };
  struct Job {
    std::string key;
    std::shared_ptr<Clouds> clouds;
    std::stop_source stop;
    std::future<std::optional<bake::LightTexels>> result;
    Clock::time_point asked;  // when somebody last wanted it
  };
  struct Kept {
    std::string key;
    std::shared_ptr<const InScatterVolume> volume;
  };
  std::shared_ptr<Clouds> clouds_of(const Wanted& wanted);
  bake::InScatterGrid grid_of(const Wanted& wanted, const InScatterPlan& plan, double threshold);
  std::shared_ptr<const InScatterVolume> kept(const std::string& key);
  std::shared_ptr<const InScatterVolume> keep(const std::string& key, Clouds& clouds, const bake::LightTexels& light);
  void take_results();
  void drop_the_forgotten();
  Job& job_of(const std::string& key, const std::shared_ptr<Clouds>& clouds, const Wanted& wanted,
              const bake::InScatterLight& light);

  gpu::VolumePass extinction_;
  gpu::UniformBlock<CloudBlock> cloud_;
  gpu::UniformBlock<InScatterBlock> block_;
  bake::LightCache cache_;
  std::list<std::shared_ptr<Clouds>> clouds_;  // most recently used first
  std::list<Kept> volumes_;                    // the same
  std::list<Job> jobs_;
  int solved_ = 0;
};

}  // namespace cloudscape::render
