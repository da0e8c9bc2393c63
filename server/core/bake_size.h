// What a cloudscape's textures take, known before they are baked.
#pragma once
#include <cstdint>

#include "core/cloudscape.h"

namespace cloudscape {

constexpr int variation_resolution = 128;  // of the variation map, texels a side

constexpr int bytes_per_texel(VolumeFormat format) { return format == VolumeFormat::r16f ? 2 : 4; }

// Bytes of the shape texture; of an OpenVDB file, whose shape is not known, at most. Voxels are R16F.
constexpr std::uint64_t shape_bytes(const Volume& volume) {
  const auto cube = [](std::uint64_t side) { return side * side * side; };
  const auto& size = volume.grid.size;
  switch (volume.kind) {
    case VolumeKind::noise:
      return cube(volume.resolution) * bytes_per_texel(volume.format);
    case VolumeKind::vdb:
      return cube(volume.grid.resolution) * bytes_per_texel(VolumeFormat::r16f);
    case VolumeKind::grid:
      return std::uint64_t(size[0]) * size[1] * size[2] * bytes_per_texel(VolumeFormat::r16f);
    default:
      return 4;
  }
}

// Bytes of the textures on the device: shape, detail (RGBA8) and variation map (RGBA32F).
constexpr std::uint64_t bake_bytes(const Cloudscape& cloudscape) {
  const std::uint64_t side = cloudscape.volume.kind == VolumeKind::noise ? cloudscape.detail.resolution : 1;
  return shape_bytes(cloudscape.volume) + 4 * side * side * side +
         std::uint64_t{16} * variation_resolution * variation_resolution;
}

}  // namespace cloudscape
