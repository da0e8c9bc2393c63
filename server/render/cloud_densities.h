// Mean densities of clouds in the cells of a coarse grid of their tile, which what is baked of light in the clouds is
// marched through. They depend on the clouds alone, upright ones: neither on the light nor on how the wind makes them
// lean. Baked in slices of a few milliseconds; whoever marches through the same clouds shares them.
#pragma once
#include <list>
#include <memory>
#include <vector>

#include "bake/baked_cloudscape.h"
#include "core/frame.h"
#include "gpu/pass.h"
#include "render/blocks.h"

namespace cloudscape::render {

class CloudDensities {
 public:
  explicit CloudDensities(gpu::ShaderLibrary& shaders);
  struct Wanted {
    const FrameRequest& request;
    const CloudBlock& cloud;  // of the request
    std::shared_ptr<const bake::BakedCloudscape> baked;
    bool rests = false;  // takes the last that is done, if one is, and bakes nothing
  };
  struct Density {
    std::weak_ptr<const bake::BakedCloudscape> baked;
    std::vector<vec4> key;
    gpu::Texture cells;
    int next_layer = 0;
    bool is_done() const { return next_layer >= cells.depth(); }
  };
  // Of these clouds, baked or not: the same object for whoever asks.
  std::shared_ptr<Density> of(const Wanted& wanted);
  void bake_slice(const CloudBlock& cloud, Density& density);  // binds blocks of its own
  void reload(gpu::ShaderLibrary& shaders);
  int slices() const { return slices_; }  // baked so far

  static constexpr int across = 96, layers = 16;  // cells of a level: tuned, a volume of sharper shadows bakes longer
  static constexpr int layers_per_slice = 4;      // as many as a work group has

 private:
  gpu::VolumePass pass_;
  gpu::UniformBlock<CloudBlock> cloud_block_;
  gpu::UniformBlock<SunBlock> block_;
  std::list<std::shared_ptr<Density>> densities_;  // most recently asked first
  int slices_ = 0;
};

// Whether there are clouds that such a grid is of.
bool has_cloud_grid(const CloudBlock& cloud, const Cloudscape& sky);
// A volume of the tile, its levels one above the other.
struct GridSize {
  int across = CloudDensities::across, layers = CloudDensities::layers;  // of a level
};
gpu::Texture cloud_grid_texture(const CloudBlock& cloud, gpu::Format format, const GridSize& size, const char* label);
SunBlock sun_block(const CloudBlock& cloud, const vec4& light);

}  // namespace cloudscape::render
