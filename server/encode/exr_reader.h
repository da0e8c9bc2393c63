// Pictures that this program wrote as EXR, read again.
#pragma once
#include <filesystem>

#include "core/frame.h"

namespace cloudscape::encode {

// Radiance, alpha and, where the file has it, the standard error of the radiance; no depth. Throws Error where it
// cannot be read or is not of this size.
Frame read_exr(const std::filesystem::path& file, const ImageSize& size_px);

}  // namespace cloudscape::encode
