// How much cloud stands between points of the clouds' tile and the light: a volume for shadows on the ground and in the
// air, and for light from farther than the march looks. A pure function of the clouds and the light's direction.
//
// It is baked in slices of a few milliseconds. A frame whose light may lag takes the last that is done of its clouds;
// others wait. Streams share them.
#pragma once
#include <list>
#include <memory>
#include <vector>

#include "bake/baked_cloudscape.h"
#include "core/frame.h"
#include "gpu/pass.h"
#include "render/blocks.h"

namespace cloudscape::render {

class SunDepths {
 public:
  explicit SunDepths(gpu::ShaderLibrary& shaders);
  struct Wanted {
    const FrameRequest& request;
    const CloudBlock& cloud;  // of the request
    std::shared_ptr<const bake::BakedCloudscape> baked;
    bool rests = false;  // takes the last that is done, if one is, and bakes nothing
  };
  // Bakes the next slice of what the frame needs; true when `depth` is there, or nothing casts a shadow. Binds blocks
  // of its own.
  bool prepare(const Wanted& wanted, std::shared_ptr<const gpu::Texture>& depth);
  void reload(gpu::ShaderLibrary& shaders);
  int slices() const { return slices_; }  // baked so far

  static constexpr int across = 96, layers = 16;  // cells of a level: tuned, a volume of sharper shadows bakes longer
  static constexpr int layers_per_slice = 4;      // as many as a work group has

 private:
  struct Light {  // what the volume depends on beside the clouds
    vec4 direction, lean;
    bool operator==(const Light&) const = default;
  };
  struct Lit {
    Light light;
    std::shared_ptr<gpu::Texture> depth;
    int next_layer = 0;
  };
  struct Clouds {
    std::weak_ptr<const bake::BakedCloudscape> baked;
    std::vector<vec4> key;
    gpu::Texture density;
    int next_layer = 0;
    std::list<Lit> lit;  // most recently asked first
    std::shared_ptr<const gpu::Texture> newest;
  };
  Clouds& clouds_of(const Wanted& wanted);
  static Lit& lit_of(Clouds& clouds, const Wanted& wanted);
  void bake_slice(const CloudBlock& cloud, Clouds& clouds, Lit& lit);

  gpu::VolumePass density_, depth_;
  gpu::UniformBlock<CloudBlock> cloud_block_;
  gpu::UniformBlock<SunBlock> block_;
  std::list<Clouds> clouds_;  // most recently asked first
  int slices_ = 0;
};

}  // namespace cloudscape::render
