// The screen passes of a frame, in their order: scene, march, smooth (moving pictures), composite, bloom, tone
// map.
#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>

#include "bake/baked_cloudscape.h"
#include "gpu/pass.h"
#include "render/bloom.h"
#include "render/in_scatter_volumes.h"
#include "render/pass_clock.h"
#include "render/sky_tables.h"
#include "render/targets.h"

namespace cloudscape::render {

// What the scene has besides the plain: each kind is a program of its own, so that only who has it pays for it.
enum class SceneKind { plain, land, water };
SceneKind scene_kind_of(const Cloudscape& cloudscape);

// Defines of the march that say what the blocks hold for every ray. Software computes both sides of every branch: a
// program that knows takes a third less time.
std::string march_kinds(const CloudBlock& cloud, SkyKind sky);

class Passes {
 public:
  Passes(const gpu::Context& context, gpu::ShaderLibrary& shaders);
  // Rows of the march target: the scene behind them, then the clouds. The blocks must be bound.
  struct Medium {
    const bake::BakedCloudscape& baked;
    const gpu::Texture& nearness;         // the distance field, or the structure
    bool distances = true;                // which of them
    std::vector<gpu::Binding> land;       // textures of the scene's terrain and water
    const gpu::Texture* phase = nullptr;  // the table of a phase function that is looked up
    const InScatterVolume* in_scatter = nullptr;
    const gpu::Texture* sun_depth = nullptr;  // where clouds cast shadows
    const gpu::Texture* ambient = nullptr;    // where the light model needs one
    SceneKind scene = SceneKind::plain;
    std::string kinds = {};  // march_kinds
  };
  void march(const Targets& targets, const SkyTables::Set& sky, const Medium& medium, int row_begin, int row_end,
             PassClock& clock) const;
  // The same for the pixels of marked tiles of which nothing is kept, where the frame block asks for those alone.
  struct NewlySeen {
    const gpu::TileMarks& marks;
    const gpu::Texture& kept;
  };
  void march_newly(const Targets& targets, const SkyTables::Set& sky, const Medium& medium, const NewlySeen& newly,
                   PassClock& clock) const;
  // The whole picture into targets.scratch, averaged with `previous`.
  void composite(const Targets& targets, const Accumulation& previous, PassClock& clock) const;
  // With the glow of `targets.bloom`, if there is one.
  void tone_map(const Targets& targets, const Accumulation& accumulation, PassClock& clock) const;
  const Bloom& bloom() const { return bloom_; }
  void reload(gpu::ShaderLibrary& shaders);

 private:
  const gpu::ScreenPass& scene_with(SceneKind kind, bool float32) const;
  const gpu::ScreenPass& march_of(const Medium& medium, bool float32) const;
  gpu::ScreenPass half_scene_, full_scene_;  // HDR targets of 16 or 32 bits
  const gpu::Context& context_;
  gpu::ShaderLibrary& shaders_;
  mutable std::array<std::optional<gpu::ScreenPass>, 4> scenes_;  // of land and water; once they are wanted
  mutable std::map<std::string, gpu::ScreenPass> marches_;        // by their defines and bits; once they are wanted
  gpu::ScreenPass smooth_, composite_, composite_alone_, tone_map_, tone_map_bloom_;
  gpu::Texture nothing_kept_;  // where every pixel is asked for
  Bloom bloom_;
};

}  // namespace cloudscape::render
