// A folder of this process, removed with all that is in it.
#pragma once
#include <unistd.h>

#include <filesystem>
#include <string>

namespace cloudscape::app {

class TemporaryFolder {
 public:
  TemporaryFolder() { std::filesystem::create_directories(path_); }
  ~TemporaryFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("cloudscape-bench-" + std::to_string(getpid()));
};

}  // namespace cloudscape::app
