// A 3D texture as one EXR picture: its horizontal slices side by side.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace cloudscape::encode {

// `rgba8`: width * width * depth texels, x fastest, then y, then z (bottom to top). Slice z stands in column z %
// columns and row z / columns of the picture, with columns = ceil(sqrt(depth)); inside a slice north is up. Channels R
// G B A, half floats in 0..1. `attributes` are written as strings, "slices", "columns" and "side" as integers. Throws
// Error.
std::vector<std::uint8_t> slice_atlas_exr(std::span<const std::uint8_t> rgba8, int side, int depth,
                                          const std::map<std::string, std::string>& attributes);

}  // namespace cloudscape::encode
