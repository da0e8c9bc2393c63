// Whether a file holds a whole picture, without decoding it.
#pragma once
#include <filesystem>

#include "core/frame.h"

namespace cloudscape::encode {

// True where the file is of this format and size and reaches to its end: JPEG from its frame header to EOI (ITU-T T.81,
// B.1), PNG from IHDR to IEND, OpenEXR with every block of lines written and the last one readable. Never throws: what
// cannot be read is not whole.
bool is_whole_image(const std::filesystem::path& path, ImageFormat format, const ImageSize& size_px);

}  // namespace cloudscape::encode
