#include "bake/height_map.h"

#include <algorithm>
#include <cmath>

#include "core/cloudscape_terrain.h"
#include "core/error.h"

namespace cloudscape::bake {
namespace {

namespace fs = std::filesystem;

// How much each pixel of a line counts for a point of a coarser or finer line: a tent about the point, as wide as the
// wider of the two spacings.
struct Tap {
  int first = 0;
  std::vector<float> weights;
};

std::vector<Tap> taps_of(int pixels, int points) {
  const double step = static_cast<double>(pixels) / points, reach = std::max(1.0, step);
  std::vector<Tap> taps;
  for (int point = 0; point < points; ++point) {
    const double center = (point + 0.5) * step - 0.5;
    Tap tap{static_cast<int>(std::floor(center - reach)) + 1, {}};
    double sum = 0;
    for (int pixel = tap.first; pixel < center + reach; ++pixel) {
      tap.weights.push_back(static_cast<float>(std::max(0.0, 1 - std::abs(pixel - center) / reach)));
      sum += tap.weights.back();
    }
    for (float& weight : tap.weights) weight /= static_cast<float>(sum);
    taps.push_back(std::move(tap));
  }
  return taps;
}

float tapped(const Tap& tap, const float* line, int pixels, std::ptrdiff_t stride) {
  float sum = 0;
  for (std::size_t i = 0; i < tap.weights.size(); ++i)
    sum += tap.weights[i] * line[stride * std::clamp(tap.first + static_cast<int>(i), 0, pixels - 1)];
  return sum;
}

void check_values(const HeightMap& map) {
  constexpr float highest = 1e5F;  // a hundred kilometres, where the map is in metres
  for (const float value : map.values)
    if (!(std::abs(value) <= highest))
      throw Error("holds heights that are not finite or beyond 100000: repair it in the program that made it");
}

}  // namespace

namespace detail {

void check_size(std::int64_t width, std::int64_t height) {
  if (width >= 1 && height >= 1 && width <= max_height_map_side && height <= max_height_map_side &&
      width * height <= max_height_map_pixels)
    return;
  throw Error("has " + std::to_string(width) + "x" + std::to_string(height) + " pixels: scale it down to at most " +
              std::to_string(max_height_map_side) + " a side");
}

}  // namespace detail

HeightMap read_height_map(const fs::path& folder, const std::string& name) {
  const std::string what = "the height map '" + name + "' ";
  if (!is_height_map_name(name)) throw UnusableFile(what + "is no bare name of a .png or .exr file");
  if (folder.empty())
    throw UnusableFile(what + "cannot be read: there is no folder of height maps, name one with --height-map-dir");
  const fs::path file = folder / name;
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    throw UnusableFile(what + "is not in the folder of height maps: put it there, or name another");
  try {
    HeightMap map = name.ends_with(".png") ? detail::read_png_height_map(file) : detail::read_exr_height_map(file);
    check_values(map);
    return map;
  } catch (const Error& reason) {
    throw UnusableFile(what + reason.what());
  }
}

std::vector<float> resampled(const HeightMap& map, int side) {
  const std::vector<Tap> columns = taps_of(map.width, side), rows = taps_of(map.height, side);
  const std::size_t width = static_cast<std::size_t>(side);
  std::vector<float> narrow(width * static_cast<std::size_t>(map.height)), points(width * width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(map.height); ++y)
    for (std::size_t x = 0; x < width; ++x)
      narrow[y * width + x] = tapped(columns[x], &map.values[y * static_cast<std::size_t>(map.width)], map.width, 1);
  for (std::size_t y = 0; y < width; ++y)
    for (std::size_t x = 0; x < width; ++x)
      points[(width - 1 - y) * width + x] = tapped(rows[y], &narrow[x], map.height, side);
  return points;
}

}  // namespace cloudscape::bake
