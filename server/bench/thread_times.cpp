#include "bench/thread_times.h"

#include <filesystem>
#include <fstream>

namespace cloudscape::bench {

std::string without_number(const std::string& thread_name) {
  const std::size_t last = thread_name.find_last_not_of("0123456789-:");
  return last == std::string::npos ? thread_name : thread_name.substr(0, last + 1);
}

// schedstat begins with the nanoseconds on a processor (Linux, Documentation/scheduler/sched-stats.rst).
ThreadTimes thread_cpu_ms() {
  ThreadTimes times;
  std::error_code gone;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task", gone)) {
    std::string name;
    double nanoseconds = 0;
    std::getline(std::ifstream(thread.path() / "comm"), name);
    std::ifstream(thread.path() / "schedstat") >> nanoseconds;
    times[without_number(name)] += 1e-6 * nanoseconds;
  }
  return times;
}

ThreadTimes since(const ThreadTimes& before, const ThreadTimes& now) {
  ThreadTimes spent;
  for (const auto& [name, ms] : now) {
    const auto then = before.find(name);
    if (const double more = ms - (then == before.end() ? 0 : then->second); more > 0) spent[name] = more;
  }
  return spent;
}

}  // namespace cloudscape::bench
