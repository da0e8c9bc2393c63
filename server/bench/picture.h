// Pictures to be compared: rows from the top, red, green, blue of each pixel.
#pragma once
#include <glm/vec3.hpp>
#include <vector>

#include "core/frame.h"

namespace cloudscape::bench {

// Linear radiance, or display values of 0..1 (sRGB-encoded): who takes one says which.
struct Picture {
  ImageSize size_px;
  std::vector<glm::dvec3> rgb;
};

// Rec. 709.
constexpr double luminance(const glm::dvec3& linear) {
  return 0.2126 * linear.x + 0.7152 * linear.y + 0.0722 * linear.z;
}

// Means of squares of `side` by `side` pixels, of as many as fit whole.
Picture tiles_of(const Picture& picture, int side);

Picture radiance_picture(const Frame& frame);  // of a frame with radiance
// As the picture is displayed, rounded to 8 bits: exposed, through the tone curve; without dither and without bloom.
Picture display_picture(const Picture& radiance, const Display& display);

}  // namespace cloudscape::bench
