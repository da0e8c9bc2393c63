// The terrain of a frame: baked, with the shadows of the frame's sun, and as the scene pass wants it.
#pragma once
#include <filesystem>
#include <list>
#include <memory>
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
  TerrainStage(const gpu::Context& context, gpu::ShaderLibrary& shaders, std::filesystem::path height_maps);
  // Bakes the next slice of what the frame needs; true when all is there. Throws Error for a bad height map.
  bool prepare(const FrameRequest& request, Land& land);
  // Uploads and binds the block; the textures are for the scene pass.
  std::vector<gpu::Binding> bind(const FrameRequest& request, const Land& land);
  void reload(gpu::ShaderLibrary& shaders);

 private:
  struct Shadows {
    std::string key;
    std::shared_ptr<gpu::Texture> texture;
    int next_row = 0;
  };
  bool cast_shadows(const FrameRequest& request, Land& land);
  bake::TerrainStore store_;
  gpu::ScreenPass shadows_pass_;
  gpu::UniformBlock<TerrainBlock> block_;
  std::list<Shadows> shadows_;  // most recently used first
};

}  // namespace cloudscape::render
