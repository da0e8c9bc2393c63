// How long frames take: one view, rendered again and again, with nothing kept from frame to frame.
#pragma once
#include <string>
#include <vector>

#include "core/frame.h"
#include "render/renderer.h"

namespace cloudscape::bench {

struct Spread {
  double median_ms = 0, p95_ms = 0, max_ms = 0;
};
Spread spread_of(std::vector<double> values_ms);  // nearest rank; zeros where there are none

struct FrameTimes {
  std::string cloudscape, quality;
  ImageSize size_px;
  int march_divisor = 1, frames = 0;
  Spread render, gpu, encode;         // wall time of the render thread; device time; JPEG of quality 80, 4:2:0
  double jpeg_bytes = 0;              // of a frame, mean
  std::vector<PassTime> passes = {};  // of one more frame, whose passes are waited for
};

// Renders `frames` frames after `warm_up` that are not counted (they bake, and compile shaders).
FrameTimes measure_frames(render::Renderer& renderer, const FrameRequest& request, int frames, int warm_up = 2);

std::string table_of(const std::vector<FrameTimes>& rows);  // for people
std::string json_of(const std::vector<FrameTimes>& rows, const std::string& renderer,
                    const std::string& pass_execution);

}  // namespace cloudscape::bench
