// The textures that a frame is rendered into; kept and shared between frames of one size.
#pragma once
#include <list>
#include <memory>
#include <vector>

#include "core/frame.h"
#include "gpu/context.h"
#include "gpu/texture.h"
#include "render/bloom_chain.h"

namespace cloudscape::render {

// The average of a stream's samples so far.
struct Accumulation {
  gpu::Texture radiance, depth;
  std::size_t bytes() const { return radiance ? radiance.bytes() + depth.bytes() : 0; }
};
Accumulation make_accumulation(ImageSize size);

// Where the rays lie in the targets of scene and march. llvmpipe works tile by tile, each on one core: `over_tiles`
// lays a small picture's rays over four tiles or more, evenly. Only for pictures that are marched whole and averaged
// with nothing.
enum class RayPlaces { first, over_tiles };

struct Targets {
  ImageSize size, march_size;
  glm::ivec2 march_origin{0};  // of the first ray in the targets of scene and march
  int march_divisor = 1;
  bool float32 = false;
  bool smooth = false;
  gpu::Texture scene_radiance, scene_depth, march_radiance, march_depth, smooth_radiance, smooth_depth, display;
  Accumulation scratch;
  std::unique_ptr<BloomChain> bloom;  // made when a picture first glows; nullptr: this one does not
  // What the composite reads of the march.
  const gpu::Texture& clouds() const { return smooth ? smooth_radiance : march_radiance; }
  const gpu::Texture& clouds_depth() const { return smooth ? smooth_depth : march_depth; }
};

// Of moving pictures that are continued. llvmpipe cuts what 16 bits do not hold off instead of rounding it, so that
// such a picture goes dark; and 32 cost it nothing.
gpu::Format kept_format(const gpu::Context& context);

// Gives `targets` the chain that the request's glow needs, or none.
void prepare_bloom(Targets& targets, const FrameRequest& request);

class TargetPool {
 public:
  // tuned: sizes that alternate without being made anew each time; a moving picture has two, for its rays and for what
  // it newly sees.
  static constexpr std::size_t most_free = 8;
  std::unique_ptr<Targets> acquire(ImageSize size, const RenderQuality& quality, RayPlaces places = RayPlaces::first);
  void release(std::unique_ptr<Targets> targets);
  std::size_t size() const { return free_.size(); }

 private:
  std::list<std::unique_ptr<Targets>> free_;  // most recently released first
};

}  // namespace cloudscape::render
