// Processor time of this process: of all its threads, and by what they do.
#pragma once
#include <map>
#include <string>

namespace cloudscape::bench {

// Of the threads that there are, by name; threads whose names differ only in a number at the end count together.
using ThreadTimes = std::map<std::string, double>;
ThreadTimes thread_cpu_ms();
std::string without_number(const std::string& thread_name);  // "llvmpipe-1": "llvmpipe"

// What each took since; threads that took nothing are left out.
ThreadTimes since(const ThreadTimes& before, const ThreadTimes& now);

}  // namespace cloudscape::bench
