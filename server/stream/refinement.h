// The steps from the first sharp picture of a resting view to its final one: every frame doubles the samples of the
// average, so that each looks better than the last and none costs more than all before it.
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/frame.h"

namespace cloudscape::stream {

constexpr std::uint8_t moving_stage = 0, final_stage = 255;

struct RefinementStep {
  int first_sample = 0;  // that the average holds already
  int samples = 1;       // to add
  std::uint8_t stage = final_stage;
  Encoding encoding;
};

// `accumulated` samples stand in the average (0, then powers of two), fewer than `wanted`.
constexpr RefinementStep refinement_step(int accumulated, int wanted) {
  // tuned: the bytes of frames that are soon replaced against their artefacts; the last one stays on the screen, and at
  // 95 without chroma subsampling a JPEG of clouds cannot be told from its original.
  constexpr int first_quality = 85, quality_step = 2, last_refining_quality = 92, final_quality = 95;
  const int samples = std::min(std::max(accumulated, 1), wanted - accumulated);
  if (accumulated + samples >= wanted)
    return {accumulated, samples, final_stage, {ImageFormat::jpeg, final_quality, ChromaSubsampling::none}};
  const int stage = std::bit_width(static_cast<unsigned>(accumulated)) + 1;
  const int quality = std::min(first_quality + quality_step * (stage - 1), last_refining_quality);
  return {
      accumulated, samples, static_cast<std::uint8_t>(stage), {ImageFormat::jpeg, quality, ChromaSubsampling::half}};
}

}  // namespace cloudscape::stream
