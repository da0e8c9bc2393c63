// A baked terrain on the device, and the job that bakes one in slices.
#pragma once
#include <future>
#include <memory>
#include <optional>

#include "bake/blocks.h"
#include "bake/kept_files.h"
#include "bake/terrain_texels.h"
#include "gpu/pass.h"

namespace cloudscape::bake {

class BakedTerrain {
 public:
  explicit BakedTerrain(const TerrainTexels& texels);
  const TerrainRecipe& recipe() const { return recipe_; }
  const gpu::Texture& heights() const { return heights_; }          // RG32F with levels, nearest; see TerrainTexels
  const gpu::Texture& surface() const { return surface_; }          // RGBA16F with levels, linear
  const std::vector<float>& points_m() const { return points_m_; }  // the lattice, m above the base
  float lowest_m() const { return lowest_m_; }                      // above the base
  float highest_m() const { return highest_m_; }
  std::size_t bytes() const { return (heights_.bytes() + surface_.bytes()) * 4 / 3; }

 private:
  TerrainRecipe recipe_;
  gpu::Texture heights_, surface_;
  std::vector<float> points_m_;
  float lowest_m_, highest_m_;
};

// Noise is made on the device, rows at a time, and kept in `files`; files are read, and levels made, on a thread of
// their own.
class TerrainJob {
 public:
  TerrainJob(const gpu::ScreenPass& noise, TerrainRecipe recipe, std::filesystem::path folder, KeptFiles files);
  // Goes on with the bake, for some milliseconds; true when it is done. Throws what read_height_map throws.
  bool advance();
  double progress() const;                     // 0..1
  std::shared_ptr<const BakedTerrain> take();  // once advance() said true

 private:
  void bake_rows();
  void load_noise();
  void begin_noise();
  const gpu::ScreenPass& noise_;
  TerrainRecipe recipe_;
  KeptFiles files_;
  gpu::Texture heights_;
  gpu::UniformBlock<TerrainBakeBlock> block_;
  int next_row_ = 0;
  std::future<std::optional<TerrainTexels>> texels_;  // nullopt: the file was damaged
  std::shared_ptr<const BakedTerrain> baked_;
};

}  // namespace cloudscape::bake
