#include "bench/picture.h"

#include <cmath>
#include <glm/glm.hpp>

#include "bench/display_curve.h"

namespace cloudscape::bench {

Picture tiles_of(const Picture& picture, int side) {
  const auto [width, height] = picture.size_px;
  Picture tiles{{width / side, height / side}, {}};
  tiles.rgb.resize(std::size_t(tiles.size_px.width) * tiles.size_px.height);
  for (int y = 0; y < tiles.size_px.height * side; ++y)
    for (int x = 0; x < tiles.size_px.width * side; ++x)
      tiles.rgb[y / side * tiles.size_px.width + x / side] += picture.rgb[y * width + x] / double(side * side);
  return tiles;
}

Picture radiance_picture(const Frame& frame) {
  Picture picture{frame.request.size_px, {}};
  const std::vector<float>& rgba = frame.radiance_rgba;
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) picture.rgb.emplace_back(rgba[i], rgba[i + 1], rgba[i + 2]);
  return picture;
}

Picture display_picture(const Picture& radiance, const Display& display) {
  const float exposure = std::exp2(static_cast<float>(display.exposure_ev));
  Picture shown{radiance.size_px, {}};
  for (const glm::dvec3& rgb : radiance.rgb) {
    const glm::dvec3 value = shown_radiance(rgb, exposure, static_cast<int>(display.tone_curve));
    shown.rgb.push_back(glm::round(value * 255.0) / 255.0);
  }
  return shown;
}

}  // namespace cloudscape::bench
