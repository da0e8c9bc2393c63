// Numbers of 16 bits among the bytes of texels.
#pragma once
#include <cstdint>
#include <cstring>
#include <glm/gtc/packing.hpp>

namespace cloudscape::bake {

inline float half_at(const std::uint8_t* bytes) {
  std::uint16_t half = 0;
  std::memcpy(&half, bytes, sizeof half);
  return glm::unpackHalf1x16(half);
}

inline void store_half(float value, std::uint8_t* bytes) {
  const std::uint16_t half = glm::packHalf1x16(value);
  std::memcpy(bytes, &half, sizeof half);
}

}  // namespace cloudscape::bake
