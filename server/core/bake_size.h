// What a cloudscape's textures take, known before they are baked.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "core/cloudscape.h"

namespace cloudscape {

constexpr int variation_resolution = 128;  // of the variation map, texels a side

// Texels of the shape texture: what `volume.format` asks for, or of several layers coverage and density.
enum class ShapeFormat { rgba8, r16f, rg16f };
template <>
struct EnumNames<ShapeFormat> {
  static constexpr std::array<std::string_view, 3> names{"rgba8", "r16f", "rg16f"};
};

constexpr int bytes_per_texel(ShapeFormat format) { return format == ShapeFormat::r16f ? 2 : 4; }

// Voxels are R16F.
constexpr ShapeFormat shape_format(const Cloudscape& cloudscape) {
  if (is_layered(cloudscape)) return ShapeFormat::rg16f;
  const bool mixed = cloudscape.volume.format == VolumeFormat::r16f || is_from_file(cloudscape.volume.kind);
  return mixed ? ShapeFormat::r16f : ShapeFormat::rgba8;
}

// Bytes of the shape texture; of an OpenVDB file, whose shape is not known, at most.
constexpr std::uint64_t shape_bytes(const Cloudscape& cloudscape) {
  const auto cube = [](std::uint64_t side) { return side * side * side; };
  const Volume& volume = cloudscape.volume;
  const int texel_bytes = bytes_per_texel(shape_format(cloudscape));
  const auto& size = volume.grid.size;
  switch (volume.kind) {
    case VolumeKind::noise:
      return cube(volume.resolution) * texel_bytes;
    case VolumeKind::vdb:
      return cube(volume.grid.resolution) * texel_bytes;
    case VolumeKind::grid:
      return std::uint64_t(size[0]) * size[1] * size[2] * texel_bytes;
    default:
      return 4;
  }
}

// Bytes of the textures on the device: shape, detail (RGBA8) and variation map (RGBA32F).
constexpr std::uint64_t bake_bytes(const Cloudscape& cloudscape) {
  const std::uint64_t side = cloudscape.volume.kind == VolumeKind::noise ? cloudscape.detail.resolution : 1;
  return shape_bytes(cloudscape) + 4 * side * side * side +
         std::uint64_t{16} * variation_resolution * variation_resolution;
}

}  // namespace cloudscape
