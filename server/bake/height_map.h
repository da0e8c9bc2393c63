// Height maps from files: grey PNG and one-channel EXR, checked as files of strangers.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cloudscape::bake {

constexpr int max_height_map_side = 8192;
constexpr std::int64_t max_height_map_pixels = std::int64_t{64} << 20;

struct HeightMap {
  int width = 0, height = 0;
  std::vector<float> values;  // top row first; 0..1 of a PNG, as they are of an EXR
};

// Reads `name` of `folder`. Throws UnusableFile, one sentence that names the file and the remedy: it is missing,
// damaged, too large, not grey, has other channels or values that are not finite. Thread-safe.
HeightMap read_height_map(const std::filesystem::path& folder, const std::string& name);

// A map as a square lattice of side^2 points, bottom (south) row first, point (i, j) at the middle of the pixel of a
// map of that size: bilinear, or the mean over the pixels that a point stands for where the map is finer.
std::vector<float> resampled(const HeightMap& map, int side);

namespace detail {
HeightMap read_png_height_map(const std::filesystem::path& file);
HeightMap read_exr_height_map(const std::filesystem::path& file);
void check_size(std::int64_t width, std::int64_t height);
}  // namespace detail

}  // namespace cloudscape::bake
