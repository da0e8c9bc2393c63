#include "bench/picture.h"

#include <cmath>
#include <glm/glm.hpp>

#include "bench/display_curve.h"

namespace cloudscape::bench {

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
