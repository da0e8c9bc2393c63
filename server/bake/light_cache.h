// The light of in-scatter volumes on disk, beside the bakes.
#pragma once
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bake/in_scatter.h"
#include "bake/kept_files.h"

namespace cloudscape::bake {

// Texels of the two textures of a volume, level by level: mean radiance and the share of the sun's beam that arrives;
// mean of radiance times direction, in mean radiances (by luminance), and 0.
struct LightTexels {
  std::vector<glm::vec4> mean, directed;
  bool operator==(const LightTexels&) const = default;
};
// Of all levels, rounded to what the cache keeps, so that light from the disk is the same as light that was just
// solved.
LightTexels light_texels(const std::vector<InScatterSolution>& levels);

class LightCache {
 public:
  explicit LightCache(KeptFiles files) : files_(std::move(files)) {}
  // `key`: hexadecimal, of all that the light depends on. nullopt if it is not there.
  std::optional<LightTexels> load(const std::string& key, std::size_t texels) const;
  void store(const std::string& key, const LightTexels& light) const;

 private:
  KeptFiles files_;
};

}  // namespace cloudscape::bake
