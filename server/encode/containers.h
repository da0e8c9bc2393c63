// Sequences of frames as one file, written as they come: what is kept in memory are a few bytes a frame.
#pragma once
#include <filesystem>
#include <memory>

#include "core/frame_container.h"

namespace cloudscape::encode {

// Makes the file. Throws Error.
//
// ZIP through libarchive, stored: frame_0007.jpg and so on, four digits or as many as the last number has. The files'
// time is 1980-01-01, where a ZIP's times begin.
// AVI 1.0 with an idx1 index: one video stream MJPG. Adding a frame that would make it 2 GiB or more throws.
std::unique_ptr<FrameContainer> open_container(const std::filesystem::path& path, const ContainerLayout& layout);

std::unique_ptr<FrameContainer> open_zip(const std::filesystem::path& path, const ContainerLayout& layout);
// Offsets are 32 bit, and many readers take them as signed: OpenDML, which goes beyond, is not written.
constexpr std::uint64_t max_avi_bytes = (std::uint64_t{1} << 31) - 1;
std::unique_ptr<FrameContainer> open_avi(const std::filesystem::path& path, const ContainerLayout& layout,
                                         std::uint64_t max_bytes = max_avi_bytes);

}  // namespace cloudscape::encode
