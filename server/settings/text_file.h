// Small text files: read whole, and written so that a reader sees the old text or the new, never a part.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace cloudscape::settings {

// Throws Error: cannot be read, or larger than `max_bytes`.
std::string read_text_file(const std::filesystem::path& file, std::size_t max_bytes);
// Through a file beside it that is flushed to the disk and renamed. Throws Error.
void write_text_file(const std::filesystem::path& file, std::string_view text);

}  // namespace cloudscape::settings
