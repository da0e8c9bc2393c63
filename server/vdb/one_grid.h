// The bytes of one grid of an OpenVDB file, checked before OpenVDB itself sees them: it trusts the lengths that a file
// claims, and takes no notice of a file that ends early.
#pragma once
#include <filesystem>
#include <string>

namespace cloudscape::vdb {

struct OneGrid {
  std::string bytes;       // a whole OpenVDB stream with this grid alone
  std::string grid_class;  // "fog volume", "level set", ...; "" if the file does not say
};

// Throws UnusableFile, one sentence without the file's name.
OneGrid one_grid(const std::filesystem::path& file, const std::string& grid);

}  // namespace cloudscape::vdb
