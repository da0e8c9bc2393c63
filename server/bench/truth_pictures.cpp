#include "bench/truth_pictures.h"

#include <cmath>
#include <glm/common.hpp>

#include "encode/encode.h"
#include "settings/text_file.h"

namespace cloudscape::bench {

std::string picture_file(const std::string& view, const std::string& column) { return view + "-" + column + ".png"; }

std::string flip_map_file(const std::string& view, const std::string& column) {
  return view + "-" + column + "-flip.png";
}

void write_picture(const std::filesystem::path& file, const Picture& display) {
  Frame frame;
  frame.request.size_px = display.size_px;
  for (const glm::dvec3& rgb : display.rgb) {
    for (int c = 0; c < 3; ++c) frame.display_rgba.push_back(static_cast<std::uint8_t>(std::lround(255 * rgb[c])));
    frame.display_rgba.push_back(255);
  }
  Encoding encoding;
  encoding.format = ImageFormat::png;
  settings::write_whole_file(file, encode::encode(frame, encoding).bytes);
}

Picture flip_map(const std::vector<double>& errors, const ImageSize& size_px) {
  Picture map{size_px, {}};
  for (const double error : errors)
    map.rgb.push_back(glm::clamp(glm::dvec3(6 * error) - glm::dvec3(0, 1, 2), 0.0, 1.0));
  return map;
}

}  // namespace cloudscape::bench
