// Small recipes and bakes of them, and a folder for the cache.
#pragma once
#include "bake/baker.h"
#include "gpu/gpu/fixture.h"

namespace cloudscape::bake {

// Quick to bake, and with all that a recipe can ask for: both noises, a mixture, several octaves, towers.
inline BakeRecipe small_recipe() {
  BakeRecipe recipe;
  recipe.seed = 5;
  recipe.resolution = recipe.detail_resolution = 16;
  recipe.height_over_width = 0.25;
  recipe.noise.channels = {NoiseChannel{0.5, 4, 2, 2, 0.5, 1}, NoiseChannel{1, 2, 3, 2, 0.6, 1},
                           NoiseChannel{0, 4, 2, 2, 0.5, 1}, NoiseChannel{1, 4, 1, 2, 0.5, 1}};
  recipe.towers = {Tower{{0.3, 0.4}, 0.1, 0.8, 0.5}, Tower{{0.7, 0.6}, 0.2, 0.9, 0.9}};
  recipe.detail_frequency = 2;
  recipe.detail_octaves = 2;
  return recipe;
}

// One texel, but for the variation map.
inline BakeRecipe tiny_recipe(std::uint32_t seed) {
  BakeRecipe recipe;
  recipe.seed = seed;
  recipe.resolution = recipe.detail_resolution = 1;
  for (NoiseChannel& channel : recipe.noise.channels) channel.octaves = 1;
  return recipe;
}

class BakeTest : public gpu::GpuTest {
 protected:
  BakedTexels bake(const BakeRecipe& recipe) {
    const std::unique_ptr<BakeJob> job = baker_.begin(recipe);
    while (!job->advance()) continue;
    return job->texels();
  }
  gpu::ShaderLibrary shaders_;
  Baker baker_{context(), shaders_};
};

// Removed at its end.
class CacheFolder {
 public:
  CacheFolder() { std::filesystem::remove_all(path_); }
  ~CacheFolder() { std::filesystem::remove_all(path_); }
  CacheFolder(const CacheFolder&) = delete;
  CacheFolder& operator=(const CacheFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) names.push_back(entry.path().filename());
    return names;
  }

 private:
  static inline int count_ = 0;
  std::filesystem::path path_ = std::filesystem::temp_directory_path() /
                                ("cloudscape-cache-" + std::to_string(getpid()) + "-" + std::to_string(count_++));
};

}  // namespace cloudscape::bake
