// The private folder of one process for the results of its jobs.
#pragma once
#include <filesystem>

namespace cloudscape::net {

// Made with the process's eyes only (0700) and locked while the process lives: so what a killed process left is known,
// and the next one removes it. Gone with this object.
class JobFolder {
 public:
  // Below `parent`; empty: the system's folder for temporary files. Throws Error.
  explicit JobFolder(const std::filesystem::path& parent);
  ~JobFolder();
  JobFolder(const JobFolder&) = delete;
  JobFolder& operator=(const JobFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace cloudscape::net
