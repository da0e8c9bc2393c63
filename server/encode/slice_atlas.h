// A 3D texture as one EXR picture: its horizontal slices side by side.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/bake_size.h"

namespace cloudscape::encode {

// `texels`: width * width * depth of them, x fastest, then y, then z (bottom to top). Slice z stands in column z %
// columns and row z / columns of the picture, with columns = ceil(sqrt(depth)); inside a slice north is up. Half
// floats: channels R G B A in 0..1 for rgba8, one channel Y for r16f, R G for rg16f. `attributes` are written as
// strings, "slices", "columns" and "side" as integers. Throws Error.
std::vector<std::uint8_t> slice_atlas_exr(std::span<const std::uint8_t> texels, int side, int depth,
                                          const std::map<std::string, std::string>& attributes,
                                          ShapeFormat format = ShapeFormat::rgba8);

}  // namespace cloudscape::encode
