// Makes a picture that was rendered small as large as it is shown.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/frame.h"

namespace cloudscape {

// `rgba`: enlargement.from_px.width * from_px.height * 4 bytes, top row first; returns to_px.width * to_px.height * 4.
// By a cubic between interpolation and blur, weights of 1/64: even areas stay as they are, and slopes straight.
// By three and more: without grains, pixels that stand out from all four beside them.
std::vector<std::uint8_t> enlarged(std::span<const std::uint8_t> rgba, const Enlargement& enlargement, ImageSize to_px);
// As large as it was asked for, where it is not yet.
void enlarge(Frame& frame);

}  // namespace cloudscape
