// Small text files: read whole. And files of any kind: written so that a reader sees the old file or the new, never a
// part.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace cloudscape::settings {

// Throws Error: cannot be read, or larger than `max_bytes`.
std::string read_text_file(const std::filesystem::path& file, std::size_t max_bytes);
// Through a file beside it that is flushed to the disk and renamed. Throws Error.
void write_text_file(const std::filesystem::path& file, std::string_view text);
void write_whole_file(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);
// Throws Error if a file could not be written so; makes the file that it would go through, and removes it again.
void check_writable(const std::filesystem::path& file);

}  // namespace cloudscape::settings
