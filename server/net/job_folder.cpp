#include "net/job_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "core/error.h"
#include "core/log.h"

namespace cloudscape::net {
namespace {

namespace fs = std::filesystem;

constexpr auto prefix = "cloudscape-jobs-";

// A lock on a folder of our own, or -1: it is another's, or its process lives.
int try_lock(const fs::path& folder) {
  const int number = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  struct stat status {};
  if (number >= 0 && ::fstat(number, &status) == 0 && status.st_uid == ::geteuid() &&
      ::flock(number, LOCK_EX | LOCK_NB) == 0)
    return number;
  if (number >= 0) ::close(number);
  return -1;
}

void remove_left_behind(const fs::path& parent) {
  std::error_code error;
  for (fs::directory_iterator entry(parent, error), end; !error && entry != end; entry.increment(error)) {
    if (!entry->path().filename().string().starts_with(prefix)) continue;
    const int lock = try_lock(entry->path());
    if (lock < 0) continue;
    std::error_code failed;
    fs::remove_all(entry->path(), failed);
    ::close(lock);
    log::info("removed {}, which an ended process left", entry->path().string());
  }
}

}  // namespace

JobFolder::JobFolder(const fs::path& parent) {
  std::error_code error;
  const fs::path place = parent.empty() ? fs::temp_directory_path(error) : parent;
  if (!parent.empty()) fs::create_directories(place, error);
  remove_left_behind(place);
  // Another process that starts now may take the folder for left behind before it is locked: then the next is made.
  for (int attempt = 0; attempt < 3 && lock_ < 0; ++attempt) {
    std::string name = (place / (std::string(prefix) + "XXXXXX")).string();
    if (!::mkdtemp(name.data()))
      throw Error("cannot make a folder for the results of jobs in " + place.string() + ": " + std::strerror(errno) +
                  "; name another with jobs_dir");
    path_ = name;
    lock_ = try_lock(path_);
    if (lock_ >= 0 && fs::exists(path_, error)) return;
  }
  throw Error("cannot lock a folder for the results of jobs in " + place.string() + "; name another with jobs_dir");
}

JobFolder::~JobFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace cloudscape::net
