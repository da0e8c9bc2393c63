// Files that are worth keeping from run to run: written atomically, checked when read, the least recently used ones
// removed when there are too many bytes.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace cloudscape::bake {

class KeptFiles {
 public:
  // `folder` is made if it is missing; an empty path keeps nothing. A folder that cannot be written is told once in the
  // log.
  KeptFiles(std::filesystem::path folder, std::uint64_t limit_bytes);
  // Hands the payload of a file to `take`, which says whether it is what was expected. A file that is not, or that is
  // damaged or truncated, is told in the log and removed. False if nothing was taken.
  bool load(const std::string& name, std::string_view magic, const std::function<bool(std::string_view)>& take) const;
  bool has(const std::string& name) const;  // a file, damaged or not
  // Failure to write is told in the log, no more. `name` must end in .bake, .phase, .light, .distance or
  // .relief.
  void store(const std::string& name, std::string_view magic, std::string_view payload) const;
  std::filesystem::path path_of(const std::string& name) const { return folder_ / name; }

 private:
  void evict() const;
  std::filesystem::path folder_;
  std::uint64_t limit_bytes_;
};

}  // namespace cloudscape::bake
