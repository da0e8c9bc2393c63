// What a cloudscape's textures take, known before they are baked.
#pragma once
#include <cstdint>

#include "core/cloudscape.h"

namespace cloudscape {

constexpr int variation_resolution = 128;  // of the variation map, texels a side

constexpr int bytes_per_texel(VolumeFormat format) { return format == VolumeFormat::r16f ? 2 : 4; }

// Bytes of the textures on the device: shape, detail (RGBA8) and variation map (RGBA32F).
constexpr std::uint64_t bake_bytes(const Cloudscape& cloudscape) {
  const auto cube = [](std::uint64_t side) { return side * side * side; };
  const bool noise = cloudscape.volume.kind == VolumeKind::noise;
  const std::uint64_t shape =
      noise ? cube(cloudscape.volume.resolution) * bytes_per_texel(cloudscape.volume.format) : 4;
  const std::uint64_t detail = 4 * (noise ? cube(cloudscape.detail.resolution) : 1);
  return shape + detail + std::uint64_t{16} * variation_resolution * variation_resolution;
}

}  // namespace cloudscape
