// The terrain of a frame: baked, with the shadows of the frame's sun, and as the scene pass wants it.
#pragma once
#include <filesystem>
#include <future>
#include <list>
#include <memory>
#include <stop_token>
#include <string>

#include "bake/terrain_store.h"
#include "core/frame.h"
#include "render/blocks.h"

namespace cloudscape::render {

// What a frame holds on to while it is rendered; empty without a terrain.
struct Land {
  std::shared_ptr<const bake::BakedTerrain> terrain;
  std::shared_ptr<const gpu::Texture> sun;  // tangent of the land's height towards the sun, of each lattice point
};

TerrainBlock terrain_block(const FrameRequest& request, const bake::BakedTerrain& terrain);

class TerrainStage {
 public:
  TerrainStage(const gpu::Context& context, gpu::ShaderLibrary& shaders, std::filesystem::path height_maps,
               const bake::KeptFiles& files);
  ~TerrainStage();  // stops what is being computed
  TerrainStage(const TerrainStage&) = delete;
  TerrainStage& operator=(const TerrainStage&) = delete;
  // Bakes the next slice of what the frame needs; true when all is there. A frame whose light may lag takes the shadows
  // of a moment ago, while those of its sun are computed. Throws Error for a bad height map.
  bool prepare(const FrameRequest& request, Land& land);
  // Uploads and binds the block; the textures are for the scene pass.
  std::vector<gpu::Binding> bind(const FrameRequest& request, const Land& land);
  void reload(gpu::ShaderLibrary& shaders);

 private:
  struct Shadows {
    std::string terrain;  // terrain_key, and the water's level
    double azimuth_deg = 0;
    std::future<std::vector<float>> tangents;
    std::stop_source stop;
    std::shared_ptr<gpu::Texture> texture;  // once they are there
  };
  using ShadowsList = std::list<Shadows>;
  bool cast_shadows(const FrameRequest& request, Land& land);
  ShadowsList::iterator shadows_of(const FrameRequest& request, const Land& land);
  Shadows begin_shadows(const FrameRequest& request, const Land& land, std::string terrain) const;
  void drop_oldest();
  bake::TerrainStore store_;
  gpu::UniformBlock<TerrainBlock> block_;
  ShadowsList shadows_;  // most recently used first
};

}  // namespace cloudscape::render
