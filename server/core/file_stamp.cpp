#include "core/file_stamp.h"

#include <sys/stat.h>

namespace cloudscape {
namespace {

std::int64_t nanoseconds(const timespec& time) { return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec; }

}  // namespace

FileStamp file_stamp(const std::filesystem::path& file) {
  struct stat found {};
  if (stat(file.c_str(), &found) != 0) return {};
  return {found.st_size, nanoseconds(found.st_mtim), nanoseconds(found.st_ctim),
          static_cast<std::int64_t>(found.st_ino)};
}

}  // namespace cloudscape
