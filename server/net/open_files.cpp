#include "net/open_files.h"

#include <sys/resource.h>

#include <algorithm>

namespace cloudscape::net {

int bound_open_files() {
  constexpr rlim_t enough = 65536;  // 1 MiB of tables; max_connections is far below
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return 1024;
  if (limit.rlim_cur > enough) {
    limit.rlim_cur = std::min(limit.rlim_max, enough);
    setrlimit(RLIMIT_NOFILE, &limit);
  }
  return static_cast<int>(limit.rlim_cur);
}

}  // namespace cloudscape::net
