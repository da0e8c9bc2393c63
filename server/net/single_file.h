// The result of a job that is one picture: the picture's own file.
#pragma once
#include <filesystem>
#include <memory>

#include "core/frame_container.h"

namespace cloudscape::net {

// Takes one frame. Throws Error.
std::unique_ptr<FrameContainer> open_single_file(const std::filesystem::path& path);

}  // namespace cloudscape::net
