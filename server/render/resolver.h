// Moving pictures: keeps each stream's last picture, and continues it with the pixels that a frame marches.
#pragma once
#include <map>
#include <memory>
#include <optional>

#include "gpu/pass.h"
#include "render/bloom.h"
#include "render/pass_clock.h"
#include "render/passes.h"
#include "render/resolve_plan.h"
#include "render/targets.h"

namespace cloudscape::render {

// A frame of a moving picture on its way.
struct ResolvedFrame {
  FrameRequest asked;
  ResolvePlan plan;
  std::uint64_t frame = 0;  // of the stream's moving picture
  bool resting = false;     // shows what the frame before showed
};

class Resolver {
 public:
  Resolver(const gpu::Context& context, gpu::ShaderLibrary& shaders);
  ResolvedFrame begin(const FrameRequest& asked) const;
  // Continues the stream's picture with what was marched into `marched` (radiance and distance of what is seen). The
  // frame block of the marched request must be bound. Whether parts of the picture ask for rays of their own (what is
  // newly seen, sun and moon): newly_seen tells which.
  bool resolve(const ResolvedFrame& frame, const Accumulation& marched, PassClock& clock);
  Passes::NewlySeen newly_seen(const ResolvedFrame& frame) const;
  // Puts those, marched into `targets`, into the picture. The frame block of the newly seen request must be bound.
  void add_newly_seen(const ResolvedFrame& frame, const Targets& targets, PassClock& clock);
  // The stream's picture in display values, as small as it is kept; until the next one is. The frame block must be
  // bound.
  const gpu::Texture& present(const ResolvedFrame& frame, const Bloom& bloom, PassClock& clock);
  // Drops the stream's picture if it is not of this view: another frame, which did not continue it, has shown that.
  void outdate(const FrameRequest& shown);
  void forget(StreamId stream) { pictures_.erase(stream); }
  std::vector<StreamId> remembered() const;
  std::size_t bytes_of(StreamId stream) const;
  std::size_t bytes() const;
  void reload(gpu::ShaderLibrary& shaders);

 private:
  struct Picture {
    gpu::Texture radiance;
    gpu::Texture closeness;  // of land: 1 / distance of what is seen, 1/km
    KeptView view;
    std::uint64_t frames = 0;
  };
  struct Shared {  // by the streams of a size: nothing in it outlives a frame
    gpu::Texture even, spare, spare_closeness;
    gpu::TileMarks marks;  // what is newly seen
    std::unique_ptr<BloomChain> bloom;
  };
  Shared& shared_of(ImageSize kept, ImageSize marched);
  void develop(const gpu::Texture& radiance, const gpu::Texture* glow, ToneCurve curve);
  gpu::ScreenPass& developing(ToneCurve curve, bool glows);
  const gpu::Texture* glow(const ResolvedFrame& frame, const Bloom& bloom, const gpu::Texture& radiance);

  const gpu::Context& context_;
  gpu::ShaderLibrary& shaders_;
  std::map<std::pair<ToneCurve, bool>, gpu::ScreenPass> develop_;  // without and with a glow; once they are wanted
  gpu::ScreenPass even_, resolve_, resolve_land_, newly_seen_, newly_seen_land_;
  gpu::UniformBlock<ResolveBlock> block_;
  std::map<StreamId, Picture> pictures_;
  std::map<std::pair<int, int>, Shared> shared_;
  gpu::Texture developed_;
};

}  // namespace cloudscape::render
