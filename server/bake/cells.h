// Textures of coarse cells about the clouds, and how the last few of them are kept.
#pragma once
#include <algorithm>
#include <glm/vec3.hpp>
#include <list>
#include <utility>

#include "gpu/texture.h"

namespace cloudscape::bake {

// Looked up cell by cell; repeats east and north.
inline gpu::Texture cells(gpu::Format format, const glm::ivec3& size, const char* label) {
  gpu::Texture texture(format, size.x, size.y, size.z, label);
  texture.sample_with(gpu::Filter::nearest, gpu::Wrap::repeat, gpu::Wrap::repeat, gpu::Wrap::clamp);
  return texture;
}

// That of the key, made if it is not among the last `most`; the most recently used comes first.
template <class Key, class Make>
const gpu::Texture& kept_of(std::list<std::pair<Key, gpu::Texture>>& kept, const Key& key, std::size_t most,
                            const Make& make) {
  const auto found = std::ranges::find(kept, key, &std::pair<Key, gpu::Texture>::first);
  if (found != kept.end()) {
    kept.splice(kept.begin(), kept, found);
  } else {
    kept.emplace_front(key, make());
    if (kept.size() > most) kept.pop_back();
  }
  return kept.front().second;
}

}  // namespace cloudscape::bake
