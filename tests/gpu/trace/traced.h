// Path-traced pictures of a few pixels, and what one reads off them.
#pragma once
#include <cmath>
#include <numeric>

#include "gpu/render/fixture.h"

namespace cloudscape::render {

class TraceTest : public RenderTest {
 public:
  static Frame traced(const FrameRequest& request) { return render(request); }
};

// The mean of a colour over a picture, with its standard error.
struct Measured {
  double mean = 0, error = 0;
  double over(double expected) const { return mean / expected; }
};

inline Measured measured(const Frame& frame, std::size_t colour = 0) {
  Measured m;
  const std::size_t pixels = frame.depth_m.size();
  for (std::size_t i = 0; i < pixels; ++i) {
    m.mean += frame.radiance_rgba[4 * i + colour] / static_cast<double>(pixels);
    m.error += std::pow(frame.standard_error_rgb[3 * i + colour] / static_cast<double>(pixels), 2);
  }
  m.error = std::sqrt(m.error);
  return m;
}

// Parallel rays within `width_m`, `side`^2 pixels of so many samples. Pixels differ in nothing but their random numbers
// where all that they see is the same.
inline FrameRequest traced_beam(const Cloudscape& sky, const CameraPose& pose, int side, int samples,
                                double width_m = 1) {
  FrameRequest request = one_ray(sky, pose);
  request.lens = {LensKind::orthographic, 50, width_m};
  request.size_px = {side, side};
  request.quality = render_quality(Quality::reference);
  request.quality.samples = samples;
  return request;
}

inline FrameRequest traced_picture(const Cloudscape& sky, const CameraPose& pose, ImageSize size_px, int samples) {
  FrameRequest request = one_ray(sky, pose);
  request.size_px = size_px;
  request.quality = render_quality(Quality::reference);
  request.quality.samples = samples;
  return request;
}

}  // namespace cloudscape::render
