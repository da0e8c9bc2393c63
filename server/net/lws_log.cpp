#include "net/lws_log.h"

#include <libwebsockets.h>

#include <chrono>
#include <mutex>
#include <string>
#include <utility>

#include "core/log.h"
#include "net/limits.h"

namespace cloudscape::net {
namespace {

// libwebsockets can write a line for each turn of its loop (out of descriptors: 4.2 million within 50 s). It logs on
// the network thread; the lock is for a second server in the same process.
void emit(int level, const char* text) {
  static std::mutex mutex;
  static TokenBucket lines(5, 20);
  static std::size_t left_out = 0;
  const std::lock_guard lock(mutex);
  if (!lines.take(std::chrono::steady_clock::now())) {
    ++left_out;
    return;
  }
  std::string line(text);
  while (!line.empty() && line.back() == '\n') line.pop_back();
  if (left_out > 0) log::warn("libwebsockets: {} lines left out", std::exchange(left_out, 0));
  level == LLL_ERR ? log::error("libwebsockets: {}", line) : log::warn("libwebsockets: {}", line);
}

}  // namespace

void redirect_lws_log() { lws_set_log_level(LLL_ERR | LLL_WARN, emit); }

}  // namespace cloudscape::net
